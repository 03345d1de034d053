#include <cstdlib>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <string>

#include "lissom/core/file_io.h"
#include "lissom/model/document.h"

namespace lissom {
namespace {

const char* const kSchemaFile = "docs/guide/lissom.schema.json";

TEST(Schema, TheSchemaInTheGuideIsTheOneOfTheProgram) {
  const std::string schema = document_schema();
  if (std::getenv("LISSOM_UPDATE_SCHEMA")) {
    ASSERT_TRUE(write_file(kSchemaFile, schema));
  }
  const Result<std::string> stored = read_file(kSchemaFile);
  ASSERT_TRUE(stored);
  EXPECT_TRUE(stored.value() == schema) << "run this test with LISSOM_UPDATE_SCHEMA=1 and commit " << kSchemaFile;
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
  const nlohmann::json schema = nlohmann::json::parse(document_schema());
  Count count;
  visit(schema, schema, count);
  EXPECT_GT(count.references, 60);
  EXPECT_GT(count.fields, 120);
  const std::string text = schema.dump();
  for (const auto& [name, definition] : schema["$defs"].items()) {
    EXPECT_NE(text.find("\"#/$defs/" + name + "\""), std::string::npos) << name;
  }
}

}  // namespace
}  // namespace lissom
