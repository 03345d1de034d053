#pragma once
/// A line network that a document names by its file. The rods are made when the document is read and stand at the end of
/// Model::rods; this remembers where they came from, so that writing the document can name the file again.

#include <cstdint>
#include <string>
#include <vector>

namespace lissom {

/// What becomes a rod of a drawing.
enum class NetworkRods {
  kChains,    ///< pieces that follow each other smoothly through points of two lines are one rod
  kSegments,  ///< every straight piece is a rod
};

constexpr double kChainAngle = 0.5235987755982988;  ///< rad, sharper corners end a chain (30 degrees)

struct NetworkFile {
  std::string name;  ///< its rods are NAME-0, NAME-1, ...
  std::string file;  ///< relative to the folder of the document, with forward slashes
  std::string unit;  ///< of the coordinates in the file: "mm"
  NetworkRods rods = NetworkRods::kChains;
  double chain_angle = kChainAngle;  ///< rad

  int edges_per_piece = 0;         ///< of each straight piece of the drawing; 0: its rods have an edge length
  int rod_count = 0;               ///< of Model::rods; networks follow each other, the last one ends the list
  std::uint64_t fingerprint = 0;   ///< of these rods as they were read; another one: they have been changed since
  std::vector<std::string> notes;  ///< what was left out of the drawing
};

}  // namespace lissom
