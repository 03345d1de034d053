#include <cstdlib>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <string>

#include "lissom/core/file_io.h"
#include "lissom/model/document.h"
#include "lissom/model/rod_mesh_document.h"

namespace lissom {
namespace {

/// A format, and the file in the guide that describes it.
struct Described {
  const char* file;
  std::string (*schema)();
  int references, fields;  ///< at least
};
const Described kSchemas[] = {{"docs/guide/lissom.schema.json", document_schema, 60, 120},
                              {"docs/guide/lissom-project.schema.json", project_schema, 15, 50}};

TEST(Schema, TheSchemasInTheGuideAreThoseOfTheProgram) {
  for (const Described& format : kSchemas) {
    const std::string schema = format.schema();
    if (std::getenv("LISSOM_UPDATE_SCHEMA")) {
      ASSERT_TRUE(write_file(format.file, schema));
    }
    const Result<std::string> stored = read_file(format.file);
    ASSERT_TRUE(stored);
    EXPECT_TRUE(stored.value() == schema) << "run this test with LISSOM_UPDATE_SCHEMA=1 and commit " << format.file;
  }
}

struct Count {
  int references = 0, fields = 0;
};

void visit(const nlohmann::json& schema, const nlohmann::json& node, Count& count) {
  if (node.is_object() && node.contains("$ref")) {
    const std::string target = node["$ref"].get<std::string>();
    EXPECT_TRUE(schema.contains(nlohmann::json::json_pointer(target.substr(1)))) << target;
    ++count.references;
  }
  if (node.is_object() && node.contains("properties")) {
    for (const auto& [key, field] : node["properties"].items()) {
      EXPECT_TRUE(field.contains("description") && field["description"].get<std::string>().ends_with('.')) << key;
      ++count.fields;
    }
  }
  if (!node.is_structured()) return;
  for (const auto& child : node) visit(schema, child, count);
}

/// Every reference leads somewhere, every definition is used, every field has a sentence.
TEST(Schema, IsComplete) {
  for (const Described& format : kSchemas) {
    const nlohmann::json schema = nlohmann::json::parse(format.schema());
    Count count;
    visit(schema, schema, count);
    EXPECT_GT(count.references, format.references);
    EXPECT_GT(count.fields, format.fields);
    const std::string text = schema.dump();
    for (const auto& [name, definition] : schema["$defs"].items()) {
      EXPECT_NE(text.find("\"#/$defs/" + name + "\""), std::string::npos) << name;
    }
  }
}

}  // namespace
}  // namespace lissom
