/// Tables as spreadsheets and loggers write them, and every mistake by file, line and column.

#include "lissom/model/csv_table.h"

#include <gtest/gtest.h>
#include <string>

namespace lissom {
namespace {

CsvTable table(const std::string& text) {
  Result<CsvTable> parsed = CsvTable::parse(text, "pull.csv");
  EXPECT_TRUE(parsed) << (parsed ? "" : parsed.error().text());
  return parsed ? std::move(parsed).value() : CsvTable();
}

std::string refused(const std::string& text) {
  const Result<CsvTable> parsed = CsvTable::parse(text, "pull.csv");
  return parsed ? "accepted" : parsed.error().text();
}

TEST(CsvTable, IsReadAsItComes) {
  for (const std::string text : {"force [N], length [mm]\n1, 100\n2, 101.5\n",
                                 "\xEF\xBB\xBF"
                                 "Force [N];Length [mm]\r\n1;100\r\n\r\n2;101.5",
                                 "# a logger\nforce (N)\tlength (mm)\n1\t100\n# a pause\n2\t101.5\n",
                                 "\"force [N]\",\"length [mm]\"\n\"1\",\"100\"\n\"2\" , \"101.5\"\n"}) {
    SCOPED_TRACE(text);
    const CsvTable csv = table(text);
    ASSERT_EQ(csv.columns().size(), 2u);
    EXPECT_EQ(csv.columns()[0].name, "force");
    EXPECT_EQ(csv.columns()[1].unit, "mm");
    ASSERT_EQ(csv.rows().size(), 2u);
    const Result<Unit> unit = csv.unit(1, Measure::kLength);
    ASSERT_TRUE(unit);
    EXPECT_EQ(csv.number(csv.rows()[1], 1, unit.value()).value(), 0.1015);
  }
}

TEST(CsvTable, QuotedCellsHoldSeparatorsAndQuotes) {
  const CsvTable csv = table("place, x [mm]\n\"a \"\"b\"\", c\", 1\n");
  EXPECT_EQ(csv.rows()[0].cells[0].text, "a \"b\", c");
  EXPECT_EQ(csv.place(csv.rows()[0], 1), "pull.csv:2:15");
}

TEST(CsvTable, SaysWhereItIsWrong) {
  EXPECT_EQ(refused(""), "pull.csv: the file is empty (begin with a header such as \"force [N], length [mm]\")");
  EXPECT_EQ(refused("\n# nothing\n"),
            "pull.csv: the file is empty (begin with a header such as \"force [N], length [mm]\")");
  EXPECT_EQ(refused("\nforce [N], length [mm]\n"),
            "pull.csv:2: there are no rows after the header (add one row for each measurement)");
  EXPECT_EQ(refused("force [N], length [mm]\n1,5, 100\n"),
            "pull.csv:2: this row has 3 cells, the header 2 (write decimal points, not commas, and one cell for each "
            "column)");
  EXPECT_EQ(refused("force [N], force [mN]\n1, 2\n"),
            "pull.csv:1:12: two columns are called \"force\" (rename or remove one of them)");
  EXPECT_EQ(refused("place, x [mm]\n\"tip, 1\n"),
            "pull.csv:2: a quotation mark is not closed (close it in the same line)");
}

TEST(CsvTable, UnitsAreAskedForAndChecked) {
  const CsvTable csv = table("force, length [inch], weight [g], way [N]\n1, 2, 3, 4\n");
  EXPECT_EQ(csv.unit(0, Measure::kForce).error().text(),
            "pull.csv:1:1: the column \"force\" has no unit (write \"force [N]\", for example)");
  EXPECT_EQ(csv.unit(1, Measure::kLength).error().where, "pull.csv:1:8");
  EXPECT_EQ(csv.unit(1, Measure::kLength).error().code, ErrorCode::kUnit);
  EXPECT_EQ(csv.unit(2, Measure::kForce).error().hint, "write gf or kgf for the weight of a mass");
  EXPECT_EQ(csv.unit(3, Measure::kLength).error().message,
            "column \"way\": expected a length such as \"0.8 mm\", got a force");
}

TEST(CsvTable, CellsHaveToBeFiniteNumbers) {
  const CsvTable csv = table("force [N]; length [mm]\nNaN; 1,5\ninf; \nabc; 1e999\n");
  const Unit newton = csv.unit(0, Measure::kForce).value(), millimetre = csv.unit(1, Measure::kLength).value();
  EXPECT_EQ(csv.number(csv.rows()[0], 0, newton).error().text(),
            "pull.csv:2:1: \"NaN\" is not a finite number (correct it or remove the row)");
  EXPECT_EQ(csv.number(csv.rows()[0], 1, millimetre).error().text(),
            "pull.csv:2:6: \"1,5\" is not a finite number (write a decimal point)");
  EXPECT_EQ(csv.number(csv.rows()[1], 1, millimetre).error().message, "the cell under \"length\" is empty");
  for (const auto& [row, column] : {std::pair{1, 0}, std::pair{2, 0}, std::pair{2, 1}}) {
    EXPECT_FALSE(csv.number(csv.rows()[static_cast<std::size_t>(row)], static_cast<std::size_t>(column), newton));
  }
}

TEST(CsvTable, AColumnThatIsCalledOtherwiseIsFound) {
  const CsvTable csv = table("forces [N], time [s]\n1, 2\n");
  EXPECT_EQ(csv.required("force", "force [N]").error().text(),
            "pull.csv:1: there is no column \"force\" (is it the one called \"forces\"?)");
  EXPECT_EQ(csv.required("length", "force [N], length [mm]").error().hint,
            "begin the file with a header such as \"force [N], length [mm]\"");
}

}  // namespace
}  // namespace lissom
