#include "structure_from_wifi/readings_io.h"

#include "support/complaint.h"
#include "support/temporary_folder.h"

namespace sfw {
namespace {

const std::string kHeader = "stamp,x,y,bssid,rssi_dbm\n";
const std::string kRow = "12.5,1.25,-2.5,02:00:00:00:00:01,-47.5\n";

class ReadingIo : public test::TemporaryFolder {
 protected:
  ReadingFile readText(const std::string& text) const {
    return readReadings(write("readings.csv", text));
  }

  std::string complaintOf(const std::string& text) const {
    return test::complaintOf([&] { readText(text); });
  }

  /// The stamp of the only reading of a table.
  std::int64_t stamp(const std::string& text) const {
    const auto readings =
        readText("stamp,x,y,bssid,rssi_dbm\n" + text + ",0,0,02:00:00:00:00:01,-40\n").readings;
    return readings.front().stamp_ns;
  }
};

void expectTheRow(const ReadingFile& file) {
  ASSERT_EQ(file.readings.size(), 1U);
  EXPECT_EQ(file.readings[0].stamp_ns, 12500000000);
  EXPECT_EQ(file.readings[0].antenna_in_map, Position(1.25, -2.5));
  EXPECT_EQ(file.readings[0].bssid.str(), "02:00:00:00:00:01");
  EXPECT_EQ(file.readings[0].rssi_dbm, -47.5);
  EXPECT_TRUE(file.skipped.empty());
}

TEST_F(ReadingIo, ReadsColumnsInAnyOrderAmongOthers) {
  expectTheRow(readText(kHeader + kRow));
  expectTheRow(
      readText("rssi_dbm,ssid,y,x,bssid,frequency_mhz,stamp\n"
               "-47.5,net,-2.5,1.25,02-00-00-00-00-01,2412,12.5\n"));
}

TEST_F(ReadingIo, TakesCarriageReturnsBlanksBlankLinesAndAMissingLastNewline) {
  expectTheRow(readText("stamp,x,y,bssid,rssi_dbm\r\n12.5,1.25,-2.5,02:00:00:00:00:01,-47.5\r\n"));
  expectTheRow(
      readText(" stamp , x,y ,bssid, rssi_dbm \n\n  \n"
               " 12.5 ,1.25,\t-2.5, 02:00:00:00:00:01 ,-47.5\n\n"));
  expectTheRow(readText("stamp,x,y,bssid,rssi_dbm\n12.5,1.25,-2.5,02:00:00:00:00:01,-47.5"));
  expectTheRow(readText(kHeader + "12.5,1.25,-2.5,02:00:00:00:00:01,-47.5,and,more,fields\n"));
}

TEST_F(ReadingIo, TakesWhatSpreadsheetsWrite) {
  expectTheRow(readText("\xEF\xBB\xBF" + kHeader + kRow));
  expectTheRow(readText("stamp;x;y;bssid;rssi_dbm\n12,5;1,25;-2,5;02:00:00:00:00:01;-47,5\n"));
  expectTheRow(
      readText("sep=;\nstamp;x;y;bssid;rssi_dbm\n12.5;1.25;-2.5;02:00:00:00:00:01;-47.5\n"));
  expectTheRow(
      readText("stamp\tx\ty\tbssid\trssi_dbm\n12,5\t1,25\t-2,5\t02:00:00:00:00:01\t-47,5\n"));
}

TEST_F(ReadingIo, KeepsNanosecondsBehindADecimalComma) {
  const auto file =
      readText("stamp;x;y;bssid;rssi_dbm\n1700000000,123456789;0;0;02:00:00:00:00:01;-40\n");
  EXPECT_EQ(file.readings.front().stamp_ns, 1700000000123456789);
}

TEST_F(ReadingIo, TakesOtherNamesOfColumnsAndDates) {
  expectTheRow(readText("Timestamp,X,Y,MAC,RSSI\n12.5,1.25,-2.5,0200.0000.0001,-47.5\n"));
  expectTheRow(
      readText("stamp,x,y,bssid,rssi\n1970-01-01 00:00:12.5,1.25,-2.5,02:00:00:00:00:01,"
               "-47.5\n"));
  EXPECT_EQ(stamp("2024-05-31T12:34:56+02:00"), 1717151696000000000);
  EXPECT_NE(complaintOf(kHeader + "2024-02-30 00:00:00,0,0,02:00:00:00:00:01,-40\n"), "nothing");
}

TEST_F(ReadingIo, ReadsPositionsOfProjectedCoordinates) {
  const auto file = readText(kHeader + "1,-7541.25,4864921.5,02:00:00:00:00:01,-40\n");
  EXPECT_EQ(file.readings.front().antenna_in_map, Position(-7541.25, 4864921.5));
}

/// "'stamp', 'x'" of "stamp,x\n".
std::string listed(std::string header) {
  header.pop_back();
  for (std::size_t comma = 0; (comma = header.find(',', comma)) != std::string::npos; comma += 3) {
    header.replace(comma, 1, "', '");
  }
  return "'" + header + "'";
}

TEST_F(ReadingIo, NamesAMissingColumn) {
  for (const std::string column : {"stamp", "x", "y", "bssid", "rssi_dbm"}) {
    std::string header = kHeader;
    header.replace(header.find(column), column.size(), "other");
    EXPECT_EQ(
        complaintOf(header + kRow),
        path("readings.csv") + ": line 1: the column '" + column + "' is missing; the file has " +
            listed(header) +
            (column == "x" || column == "y" ? "; x and y may come from a file of the path: --path"
                                            : ""));
  }
}

TEST_F(ReadingIo, RefusesAFileWithoutRows) {
  EXPECT_EQ(complaintOf(""), path("readings.csv") + ": the file is empty");
  EXPECT_EQ(complaintOf(" \r\n\n"), path("readings.csv") + ": the file is empty");
  const std::string no_rows = path("readings.csv") + ": no row can be used: it has no rows";
  EXPECT_EQ(complaintOf(kHeader), no_rows);
  EXPECT_EQ(complaintOf("stamp,x,y,bssid,rssi_dbm"), no_rows);
}

TEST_F(ReadingIo, CountsSkippedRowsByReasonAndShowsTheFirst) {
  const auto file = readText(kHeader + kRow +                     //
                             "nan,0,0,02:00:00:00:00:01,-40\n"    // line 3
                             "1,inf,0,02:00:00:00:00:01,-40\n"    //
                             "1,0,here,02:00:00:00:00:01,-40\n"   //
                             "1,0,0,zz:00:00:00:00:01,-40\n"      //
                             "\n"                                 // line 7, blank
                             "1,0,0,02:00:00:00:00:01,nan\n"      //
                             "1,0,0,02:00:00:00:00:01\n"          //
                             "1\n"                                //
                             "1e300,0,0,02:00:00:00:00:01,-40\n"  //
                             "1,2e8,0,02:00:00:00:00:01,-40\n"    //
                             "2,0,0,00:00:00:00:00:00,-40\n");
  EXPECT_EQ(file.readings.size(), 1U);
  std::map<std::string, std::pair<std::size_t, std::string>> skipped;
  for (const auto& [reason, rows] : file.skipped) {
    skipped[reason] = {rows.count, rows.first};
  }
  const std::map<std::string, std::pair<std::size_t, std::string>> expected{
      {"stamp is not finite", {1, "line 3: stamp 'nan'"}},
      {"x is not finite", {1, "line 4: x 'inf'"}},
      {"y is not a number", {1, "line 5: y 'here'"}},
      {"bssid is malformed", {2, "line 6: bssid 'zz:00:00:00:00:01'"}},
      {"rssi_dbm is not finite", {1, "line 8: rssi_dbm 'nan'"}},
      {"rssi_dbm is not a number", {1, "line 9: rssi_dbm ''"}},
      {"x is not a number", {1, "line 10: x ''"}},
      {"stamp is out of range", {1, "line 11: stamp '1e300'"}},
      {"x is out of range", {1, "line 12: x '2e8'"}}};
  EXPECT_EQ(skipped, expected);
}

TEST_F(ReadingIo, ShowsAFieldOnOneLineAndCutsIt) {
  const std::string end = ",02:00:00:00:00:01,-40\n";
  const auto firstOf = [&](const std::string& field) {
    return readText(kHeader + kRow + "1,0," + field + end).skipped.begin()->second.first;
  };
  EXPECT_EQ(firstOf("\x1b[31mred"), "line 3: y '?[31mred'");
  EXPECT_EQ(firstOf("\"a\nb\""), "line 3: y 'a?b'");
  EXPECT_EQ(firstOf(std::string(1000, 'a')), "line 3: y '" + std::string(60, 'a') + "...'");
}

TEST_F(ReadingIo, SaysWhyNoRowCanBeUsed) {
  EXPECT_EQ(complaintOf(kHeader + "x,0,0,02:00:00:00:00:01,-40\n1,0,0,?,-40\n"),
            path("readings.csv") +
                ": no row can be used: bssid is malformed (line 3: bssid '?'); "
                "stamp is not a number (line 2: stamp 'x')");
}

TEST_F(ReadingIo, NamesTheUnitOfStampsSinceTheEpoch) {
  const std::vector<std::pair<std::string, std::string>> stamps{
      {"1600000000123", "milliseconds"},
      {"1600000000123456.5", "microseconds"},
      {"1600000000123456789", "nanoseconds"}};
  for (const auto& [stamp, unit] : stamps) {
    EXPECT_EQ(complaintOf(kHeader + stamp + ",0,0,02:00:00:00:00:01,-40\n"),
              path("readings.csv") +
                  ": no row can be used: stamp is out of range, and looks like " + unit +
                  ": convert it to seconds (line 2: stamp '" + stamp + "')");
  }
}

TEST_F(ReadingIo, LeavesSignalsInOtherUnitsToTheChecks) {
  EXPECT_EQ(readText(kHeader + "1,0,0,02:00:00:00:00:01,-5200\n").readings[0].rssi_dbm, -5200.0);
}

TEST_F(ReadingIo, KeepsStampsToTheNanosecond) {
  EXPECT_EQ(stamp("1700000000.123456789"), 1700000000123456789);
  EXPECT_EQ(stamp("1700000000.000000001"), 1700000000000000001);
  EXPECT_EQ(stamp("3999999999.999999999"), 3999999999999999999);
  EXPECT_EQ(stamp("0.1"), 100000000);
  EXPECT_EQ(stamp(".25"), 250000000);
  EXPECT_EQ(stamp("7."), 7000000000);
  EXPECT_EQ(stamp("+00000000012"), 12000000000);
  EXPECT_EQ(stamp("0"), 0);
}

TEST_F(ReadingIo, RoundsStampsAtTheTenthPlace) {
  EXPECT_EQ(stamp("1700000000.1234567894999"), 1700000000123456789);
  EXPECT_EQ(stamp("1700000000.1234567895"), 1700000000123456790);
  EXPECT_EQ(stamp("0.9999999999"), 1000000000);
}

TEST_F(ReadingIo, KeepsNegativeStamps) {
  EXPECT_EQ(stamp("-0.5"), -500000000);
  EXPECT_EQ(stamp("-1700000000.123456789"), -1700000000123456789);
}

TEST_F(ReadingIo, TakesOtherNotationsOfStamps) {
  EXPECT_EQ(stamp("1.5e3"), 1500000000000);
  EXPECT_EQ(stamp("25e-1"), 2500000000);
}

TEST_F(ReadingIo, RefusesStampsThatAreAlmostNumbers) {
  for (const std::string text : {"1.2.3", "--1", "-", ".", "1,5", "1 2", "12:30", "9000000000",
                                 "99999999999999999999", "-4000000001"}) {
    EXPECT_NE(complaintOf(kHeader + text + ",0,0,02:00:00:00:00:01,-40\n"), "nothing") << text;
  }
}

TEST_F(ReadingIo, NamesAFileThatCannotBeRead) {
  const std::string missing = path("missing.csv");
  EXPECT_EQ(
      test::complaintOf([&] { readReadings(missing); }).rfind(missing + ": cannot be read", 0), 0U);
  const std::string folder = folder_.string();
  EXPECT_EQ(test::complaintOf([&] { readReadings(folder); }).rfind(folder + ": cannot be read", 0),
            0U);
}

TEST_F(ReadingIo, ReadsContacts) {
  const auto contacts =
      readContacts(write("contacts.csv", "y,x,stamp\n2,1,1700000000.000000003\n"));
  ASSERT_EQ(contacts.size(), 1U);
  EXPECT_EQ(contacts[0].stamp_ns, 1700000000000000003);
  EXPECT_EQ(contacts[0].point_in_map, Position(1, 2));
  EXPECT_TRUE(readContacts(write("none.csv", "stamp,x,y\n")).empty());
}

TEST_F(ReadingIo, RefusesContactsThatCannotBeUsed) {
  const std::string file = write("contacts.csv", "stamp,x,y\n1,2,3\n1,nan,3\n");
  EXPECT_EQ(test::complaintOf([&] { readContacts(file); }),
            file + ": line 3: x is not finite: x 'nan'");
  const std::string lacking = write("lacking.csv", "stamp,x\n1,2\n");
  EXPECT_EQ(test::complaintOf([&] { readContacts(lacking); }),
            lacking + ": line 1: the column 'y' is missing; the file has 'stamp', 'x'");
}

TEST_F(ReadingIo, ReadsBackTheRobotOfEachRow) {
  const Bssid bssid = *Bssid::parse("02:00:00:00:00:01");
  const std::string awkward = "robot \"1\", old";
  const std::vector<Reading> readings{{1000, {1.0, 2.0}, bssid, -50.0, awkward},
                                      {2000, {1.0, 2.0}, bssid, -50.0, ""}};
  const std::vector<Reading> read = readText(readingsCsv(readings)).readings;
  ASSERT_EQ(read.size(), 2U);
  EXPECT_EQ(read[0].robot, awkward);
  EXPECT_EQ(read[1].robot, "");
  const std::vector<Contact> contacts =
      readContacts(write("contacts.csv", contactsCsv({{1000, {1.0, 2.0}, awkward}})));
  EXPECT_EQ(contacts.at(0).robot, awkward);
  const std::vector<PathPose> path =
      readPath(write("path.csv", pathCsv({{1000, {1.0, 2.0}, PathPose::kNoWallCount, awkward}})));
  EXPECT_EQ(path.at(0).robot, awkward);
}

TEST_F(ReadingIo, WritesNoColumnForTheOnlyRobot) {
  const Bssid bssid = *Bssid::parse("02:00:00:00:00:01");
  EXPECT_EQ(readingsCsv({{1000000000, {1.0, 2.0}, bssid, -50.0}}),
            kHeader + "1.000000000,1.0000,2.0000,02:00:00:00:00:01,-50.00\n");
  EXPECT_EQ(contactsCsv({{1000000000, {1.0, 2.0}}}), "stamp,x,y\n1.000000000,1.0000,2.0000\n");
  EXPECT_EQ(pathCsv({{1000000000, {1.0, 2.0}}}), "stamp,x,y\n1.000000000,1.0000,2.0000\n");
}

TEST_F(ReadingIo, PlacesEachReadingOnThePathOfItsRobot) {
  const std::string path =
      write("path.csv", "stamp,x,y,robot\n0,0,0,a\n0,0,5,b\n2,2,0,a\n2,2,5,b\n");
  const ReadingFile file =
      readReadings(write("scans.csv",
                         "stamp,bssid,rssi_dbm,robot\n1,02:00:00:00:00:01,-40,a\n"
                         "1,02:00:00:00:00:01,-40,b\n1,02:00:00:00:00:01,-40,c\n"),
                   path);
  ASSERT_EQ(file.readings.size(), 2U);
  EXPECT_EQ(file.readings[0].antenna_in_map, Position(1.0, 0.0));
  EXPECT_EQ(file.readings[1].antenna_in_map, Position(1.0, 5.0));
  EXPECT_EQ(file.skipped.at("the path has no pose of its robot").first, "line 4: robot 'c'");
}

}  // namespace
}  // namespace sfw
