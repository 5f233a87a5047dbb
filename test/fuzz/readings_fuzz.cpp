// CSV files of readings, contacts and way points.

#include <cmath>

#include "fuzz_target.h"
#include "structure_from_wifi/readings_io.h"

namespace sfw::fuzz {

std::vector<std::string> seeds() {
  return {
      "stamp,x,y,bssid,rssi_dbm\n1.5,0.25,-3,02:00:00:00:00:01,-50.5\n2,1e2,4,02-00-00-00-00-02,-"
      "61\n",
      "bssid,rssi_dbm,y,x,stamp,note\r\n02:00:00:00:00:0A,-70,1,2,1700000000.123456789,\"a,b\"\r\n",
      "\xef\xbb\xbfstamp;x;y;bssid;rssi_dbm\n1,5;0,25;-3;\"02:00:00:00:00:01\";-50,5\n",
      "stamp,x,y\n1,2,3\n4,5,6\n",
      "x,y\n1,2\n3,4\n",
  };
}

void feed(std::string_view input) {
  static const InputFolder folder;
  const std::string file = folder.write("readings.csv", input);
  takes([&] {
    const ReadingFile first = readReadings(file);
    require(!first.readings.empty());
    for (const Reading& reading : first.readings) {
      require(reading.antenna_in_map.allFinite() && std::isfinite(reading.rssi_dbm));
    }
    // What the package writes, it reads back without a loss.
    const std::string text = readingsCsv(first.readings);
    const ReadingFile second = readReadings(folder.write("again.csv", text));
    require(second.skipped.empty() && readingsCsv(second.readings) == text);
  });
  takes([&] {
    const std::string text = contactsCsv(readContacts(file));
    require(contactsCsv(readContacts(folder.write("again.csv", text))) == text);
  });
  takes([&] { readWayPoints(file); });
}

}  // namespace sfw::fuzz
