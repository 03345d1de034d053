#pragma once
/// Materials with numbers of their own for those that used to share one. Only design_values.cpp includes this.

#include <algorithm>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "lissom/core/result.h"

namespace lissom {

/// The material of this name as one of the model's own.
template <class M>
M& own(std::vector<M>& materials, const M& known) {
  for (M& material : materials) {
    if (material.name == known.name) return material;
  }
  materials.push_back(known);
  return materials.back();
}

template <class M>
std::string unused_name(const std::vector<M>& materials, const std::string& wanted) {
  std::string name = wanted;
  for (int number = 2;; ++number) {
    const bool used = std::any_of(materials.begin(), materials.end(), [&](const M& m) { return m.name == name; });
    if (!used) return name;
    name = wanted + " (" + std::to_string(number) + ")";
  }
}

/// Gives each user of a material its own numbers. users: what has a name and names a material; known(name): the material;
/// changed(user): whether its numbers differ; same(a, b): whether those of two users agree; set(material, user); rename(user,
/// name).
template <class M, class User, class Known, class Changed, class Same, class Set, class Rename>
Status share_out(std::vector<M>& materials, const std::vector<User>& users, const Known& known, const Changed& changed,
                 const Same& same, const Set& set, const Rename& rename) {
  std::map<std::string, std::vector<int>> by_material;
  for (int u = 0; u < static_cast<int>(users.size()); ++u) by_material[users[u].material].push_back(u);
  for (const auto& [name, all] : by_material) {
    if (std::none_of(all.begin(), all.end(), changed)) continue;
    const M original = *known(name);
    const bool alike = std::all_of(all.begin(), all.end(), [&, first = all[0]](int u) { return same(u, first); });
    for (const int u : all) {
      M* material = nullptr;
      if (alike) {
        if (u != all[0]) break;
        material = &own(materials, original);
      } else if (changed(u)) {
        M copy = original;
        const std::string label = users[u].name.empty() ? "number " + std::to_string(u) : users[u].name;
        copy.name = unused_name(materials, name + " of " + label);
        if (Status s = rename(u, copy.name); !s) return s;
        materials.push_back(std::move(copy));
        material = &materials.back();
      } else {
        continue;
      }
      set(*material, u);
      if (Status s = material->validate("material \"" + material->name + "\""); !s) return s;
    }
  }
  return {};
}

}  // namespace lissom
