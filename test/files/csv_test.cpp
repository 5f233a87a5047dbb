#include "files/csv.h"

#include "support/complaint.h"
#include "support/temporary_folder.h"

namespace sfw {
namespace {

using Rows = std::vector<std::vector<std::string>>;

class Csv : public test::TemporaryFolder {
 protected:
  /// The columns a and b of each row; a row with a problem is {problem}.
  Rows rowsOf(const std::string& text) const {
    CsvTable table(write("table.csv", text), {{"a"}, {"b"}});
    Rows rows;
    lines_.clear();
    while (table.next()) {
      rows.push_back({std::string(table.field(0)), std::string(table.field(1))});
      if (!table.problem().empty()) {
        rows.back() = {table.problem()};
      }
      lines_.push_back(table.line());
    }
    return rows;
  }

  /// The number of the only row's column a.
  std::string numberOf(const std::string& text) const {
    CsvTable table(write("table.csv", text), {{"a"}, {"b"}});
    return table.next() ? table.number(0) : "no row";
  }

  std::string complaintOf(const std::string& text) const {
    return test::complaintOf([&] { rowsOf(text); });
  }

  mutable std::vector<std::string> lines_;
};

const Rows kRows{{"1", "2"}, {"3", "4"}};
constexpr char kTooLong[] =
    "a row has more fields than the header has columns; put quotes around a text with the "
    "separator in it";

TEST_F(Csv, ReadsEverySeparatorAndLineEnd) {
  for (const std::string separator : {",", ";", "\t", " "}) {
    for (const std::string end : {"\n", "\r\n", "\r"}) {
      EXPECT_EQ(rowsOf("a" + separator + "b" + end + "1" + separator + "2" + end + "3" + separator +
                       "4" + end),
                kRows)
          << separator << end;
      EXPECT_EQ(rowsOf("\"a\"" + separator + "\"b\"" + end + "\"1\"" + separator + "2" + end + "3" +
                       separator + "\"4\""),
                kRows)
          << separator << end;
    }
  }
}

TEST_F(Csv, KeepsSeparatorsQuotesAndLineEndsInQuotes) {
  EXPECT_EQ(rowsOf("text,a,b\n\"one, two\",1,2\n\"a \"\"b\"\"\nand c\",3,4\n"), kRows);
  EXPECT_EQ(lines_, (std::vector<std::string>{"line 2", "line 3"}));
  EXPECT_EQ(rowsOf("a,b\n\"say \"\"hi\"\"\",\"\"\n\"\",x\n"),
            (Rows{{"say \"hi\"", ""}, {"", "x"}}));
  EXPECT_EQ(rowsOf("a,b\n\"x\r\ny\",2\n3,4\n"), (Rows{{"x\r\ny", "2"}, {"3", "4"}}));
  EXPECT_EQ(lines_, (std::vector<std::string>{"line 2", "line 4"}));
}

TEST_F(Csv, TakesAQuoteWithinAnUnquotedFieldAsItIs) {
  EXPECT_EQ(rowsOf("size,a,b\n6\" pipe,1,2\n7\",3,4\n"), kRows);
}

TEST_F(Csv, LosesOnlyTheRowWhoseQuoteIsNotClosed) {
  const std::string problem = "a quote is not closed, in field 1";
  EXPECT_EQ(rowsOf("text,a,b\n\"open,0,0\n\"x\",1,2\ny,3,4\n"),
            (Rows{{problem}, kRows[0], kRows[1]}));
  EXPECT_EQ(rowsOf("text,a,b\nx,1,2\n\"open,0,0\ny,3,4\n"), (Rows{kRows[0], {problem}, kRows[1]}));
  EXPECT_EQ(rowsOf("text,a,b\n\"x\"y,0,0\ny,3,4\n"), (Rows{{problem}, kRows[1]}));
  EXPECT_EQ(rowsOf("a,b\n\"open\n1,2\n3,4\n"), (Rows{{problem}, kRows[0], kRows[1]}));
  EXPECT_EQ(complaintOf("a,\"b\n1,2\n"),
            path("table.csv") + ": line 1: a quote is not closed, in field 2");
}

TEST_F(Csv, SkipsByteOrderMarkAndLinesBeforeTheHeader) {
  EXPECT_EQ(rowsOf("\xEF\xBB\xBF\"a\",b\n1,2\n3,4\n"), kRows);
  EXPECT_EQ(rowsOf("sep=;\na;b\n1;2\n3;4\n"), kRows);
  EXPECT_EQ(rowsOf("WigleWifi-1.6,appRelease=2.78,\"brand=Moog, LLC\"\na,b\n1,2\n3,4\n"), kRows);
  EXPECT_EQ(rowsOf("\n # a b\n1 2\n3 4\n"), kRows);
  EXPECT_EQ(rowsOf("a,b\n1,2\n,\n3,4\n,,,\n"), kRows);
}

TEST_F(Csv, FindsTheNamesOfRowsThatRWrites) {
  EXPECT_EQ(rowsOf("\"text\" \"a\" \"b\"\n\"1\" \"x y\" 1 2\n\"2\" \"z\" 3 4\n"), kRows);
  EXPECT_EQ(rowsOf("text;a;b\n1;x;1;2\n2;z;3;4\n"), kRows);
  EXPECT_EQ(rowsOf("\"\",\"a\",\"b\"\n\"1\",1,2\n\"2\",3,4\n"), kRows);
  EXPECT_EQ(rowsOf("a,b\n1,2,\n3,4,\n"), kRows);  // no names: a separator at the end
}

TEST_F(Csv, RefusesARowThatAStraySeparatorHasMoved) {
  EXPECT_EQ(rowsOf("text,a,b\nx,y,1,2\nz,3,4\n"), (Rows{{kTooLong}, kRows[1]}));
  EXPECT_EQ(rowsOf("a,b,text\n1,2,x,y\n3,4,z\n"), kRows);  // it moved no column asked for
}

TEST_F(Csv, ReadsDecimalCommas) {
  EXPECT_EQ(numberOf("a;b\n2,6;1\n"), "2.6");
  EXPECT_EQ(numberOf("a;b\n-1,234;1\n"), "-1.234");
  EXPECT_EQ(numberOf("a\tb\n\"1700000000,25\"\t1\n"), "1700000000.25");
  EXPECT_EQ(numberOf("a,b\n\"2,6\",1\n"), "2.6");
  EXPECT_EQ(numberOf("a,b\n\"0,234\",1\n"), "0.234");
  for (const std::string unclear : {"1,234", "1,234.5", "1,234,567"}) {
    EXPECT_EQ(numberOf("a,b\n\"" + unclear + "\",1\n"), unclear);
  }
  EXPECT_EQ(numberOf("a;b\n1.234,5;1\n"), "1.234,5");
}

TEST_F(Csv, ListsTheColumnsIfOneIsMissing) {
  const std::string start =
      path("table.csv") + ": line 1: the column 'b' is missing; the file has ";
  EXPECT_EQ(complaintOf("a,\"c, d\"\n"), start + "'a', 'c, d'");
  EXPECT_EQ(complaintOf("a;c\n"), start + "'a', 'c'");
  EXPECT_EQ(complaintOf("one;two\n"), path("table.csv") +
                                          ": line 1: the column 'a' is missing; the file has "
                                          "'one', 'two'");
  EXPECT_EQ(complaintOf("a,b,A\n"), path("table.csv") + ": line 1: the column 'a' is there twice");
  EXPECT_EQ(complaintOf(""), path("table.csv") + ": the file is empty");
  EXPECT_EQ(complaintOf("\xFF\xFE"
                        "a\0,\0"),
            path("table.csv") + ": the file is UTF-16; save it as CSV in UTF-8");
}

}  // namespace
}  // namespace sfw
