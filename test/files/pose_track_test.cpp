#include "structure_from_wifi/readings_io.h"
#include "support/complaint.h"
#include "support/temporary_folder.h"

namespace sfw {
namespace {

using test::complaintOf;

const std::string kWigle =
    "WigleWifi-1.4,appRelease=2.53,model=X,release=1,device=d,display=e,board=b,brand=m\n"
    "MAC,SSID,AuthMode,FirstSeen,Channel,RSSI,CurrentLatitude,CurrentLongitude,AltitudeMeters,"
    "AccuracyMeters,Type\n";
const std::string kPoses = "stamp,x,y\n1000,0,0\n1002,4,2\n1020,4,2\n1040,9,9\n1041,9,9\n";

std::string wigleRow(int seconds, const std::string& type = "WIFI") {
  const std::string minutes = std::to_string(16 + seconds / 60);
  const std::string rest = std::to_string(seconds % 60);
  return "02:00:00:00:00:01,\"Cafe, upstairs\",[WPA2],1970-01-01 00:" + minutes + ":" +
         (rest.size() < 2 ? "0" : "") + rest + ",1,-51,52.5,13.4,30,8," + type + "\n";
}

class PosesBesideReadings : public test::TemporaryFolder {
 protected:
  ReadingFile readText(const std::string& readings, const std::string& poses = kPoses) const {
    return readReadings(write("readings.csv", readings), write("poses.csv", poses));
  }
};

TEST_F(PosesBesideReadings, LieOnTheLineBetweenPosesButNeverInALongGap) {
  const auto file = readText(
      "stamp,bssid,rssi\n"
      "1000.5,02:00:00:00:00:01,-50\n"
      "1002,02:00:00:00:00:01,-50\n"
      "1010,02:00:00:00:00:01,-50\n"      // it stands
      "1030,02:00:00:00:00:01,-50\n"      // it drives, for 20 s
      "999.9,02:00:00:00:00:01,-50\n"     // before
      "1041.1,02:00:00:00:00:01,-50\n");  // after
  ASSERT_EQ(file.readings.size(), 3U);
  EXPECT_EQ(file.readings[0].antenna_in_map, Position(1.0, 0.5));
  EXPECT_EQ(file.readings[1].antenna_in_map, Position(4.0, 2.0));
  EXPECT_EQ(file.readings[2].antenna_in_map, Position(4.0, 2.0));
  ASSERT_EQ(file.skipped.size(), 2U);
  EXPECT_EQ(file.skipped.at("its stamp lies in a gap of over 5 s between poses").first,
            "line 5: stamp 1030.000");
  EXPECT_EQ(file.skipped.at("its stamp is before the first pose or after the last one").count, 2U);
}

TEST_F(PosesBesideReadings, DoNotDependOnTheOrderOfTheirRows) {
  const auto file = readText("stamp,bssid,rssi\n1001,02:00:00:00:00:01,-50\n",
                             "timestamp ty tx\n1002 2 4\n1000 0 0\n");
  EXPECT_EQ(file.readings.at(0).antenna_in_map, Position(2.0, 1.0));
}

TEST_F(PosesBesideReadings, PlaceTheRowsOfWigle) {
  const auto file = readText(kWigle + wigleRow(41) + wigleRow(41, "BLE"));
  ASSERT_EQ(file.readings.size(), 1U);
  EXPECT_EQ(file.readings[0].stamp_ns, 1001000000000);
  EXPECT_EQ(file.readings[0].antenna_in_map, Position(2.0, 1.0));
  EXPECT_EQ(file.readings[0].rssi_dbm, -51.0);
  EXPECT_EQ(file.readings[0].bssid.str(), "02:00:00:00:00:01");
  EXPECT_EQ(file.skipped.at("Type is not WIFI").count, 1U);
}

TEST_F(PosesBesideReadings, PlaceThePacketsOfKismet) {
  const auto file = readText(
      "ts_sec\tts_usec\tphyname\tsourcemac\tdestmac\ttransmac\tsignal\r\n"
      "1001\t500000\tIEEE802.11\t02:00:00:00:00:09\tFF:FF:FF:FF:FF:FF\t02:00:00:00:00:01\t-60\r\n"
      "1001\t500000\tIEEE802.11\t02:00:00:00:00:01\tFF:FF:FF:FF:FF:FF\t02:00:00:00:00:01\t0\r\n"
      "1001\t500000\tBluetooth\t02:00:00:00:00:01\tFF:FF:FF:FF:FF:FF\t02:00:00:00:00:01\t-60\r\n");
  ASSERT_EQ(file.readings.size(), 1U);
  EXPECT_EQ(file.readings[0].stamp_ns, 1001500000000);
  EXPECT_EQ(file.readings[0].antenna_in_map, Position(3.0, 1.5));
  EXPECT_EQ(file.readings[0].bssid.str(), "02:00:00:00:00:01");
  EXPECT_EQ(file.skipped.at("signal is 0, where Kismet has no signal").count, 1U);
  EXPECT_EQ(file.skipped.at("phyname is not IEEE802.11").count, 1U);
}

TEST_F(PosesBesideReadings, AreAskedForIfReadingsHaveNoPosition) {
  const std::string file = write("wigle.csv", kWigle + wigleRow(41));
  const std::string complaint = complaintOf([&] { readReadings(file); });
  EXPECT_NE(complaint.find("line 2: the column 'x' is missing"), std::string::npos) << complaint;
  EXPECT_NE(complaint.find("--path"), std::string::npos) << complaint;
}

TEST_F(PosesBesideReadings, AreRefusedWithBothTimesIfTheyNeverMeet) {
  const std::string complaint =
      complaintOf([&] { readText("stamp,bssid,rssi\n8200,02:00:00:00:00:01,-50\n"); });
  EXPECT_EQ(complaint, path("readings.csv") +
                           ": its readings are from 8200.000 to 8200.000 s, but the poses in " +
                           path("poses.csv") +
                           " from 1000.000 to 1041.000 s; bring both to one clock (times without "
                           "a zone are read as UTC)");
}

TEST_F(PosesBesideReadings, AreRefusedWithTheLineOfAnUnusableOne) {
  const auto complain = [&](const std::string& poses) {
    return complaintOf([&] { readText("stamp,bssid,rssi\n1,02:00:00:00:00:01,-50\n", poses); });
  };
  EXPECT_EQ(complain("stamp,x,y\n1,2,3\n2,here,3\n"),
            path("poses.csv") + ": line 3: x is not a number: x 'here'");
  EXPECT_EQ(complain("stamp,x,y\n1,2,3\n"), path("poses.csv") + ": two poses are needed; it has 1");
}

}  // namespace
}  // namespace sfw
