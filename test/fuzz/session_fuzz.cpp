// The directory that ~load_map reads: readings, contacts and the table of access points.

#include "fuzz_target.h"
#include "ros/mapping/localization.h"
#include "ros/mapping/session.h"
#include "ros/mapping/shared_mapper.h"

namespace sfw::fuzz {

std::vector<std::string> seeds() {
  return {
      "stamp,x,y,bssid,rssi_dbm\n1.5,0.25,-3,02:00:00:00:00:01,-50.5\n2,1,4,02:00:00:00:00:02,-61\n"
      "=====\nstamp,x,y\n1,2,3\n"
      "=====\naccess_points:\n  - {bssid: \"02:00:00:00:00:01\", x: 1.5, y: -2}\n"
      "  - {bssid: \"02:00:00:00:00:02\"}\n",
      "stamp,x,y,bssid,rssi_dbm\n1,0,0,02:00:00:00:00:01,-50\n\n=====\nstamp,x,y\n\n=====\n"
      "access_points: [{bssid: \"02:00:00:00:00:03\", x: 9, y: 9, name: far}]\n",
  };
}

void feed(std::string_view input) {
  static const InputFolder folder;
  const std::vector<std::string> files = parts(input, 3);
  folder.write("readings.csv", files[0]);
  folder.write("contacts.csv", files[1]);
  folder.write("access_points.yaml", files[2]);
  Config config;
  config.map.max_cells = 400'000;
  config.method = "k_visibility";  // it loads no model, so each input has a mapper of its own
  AccessPoint known;
  known.bssid = *Bssid::parse("02:00:00:00:00:01");
  SharedMapper mapper(config, {known}, jumpTolerance({}));
  takes([&] {
    const Session session = readSession(folder.path(), config.map);
    const std::size_t before = mapper.readings();
    if (takes([&] { mapper.add(session); })) {
      require(mapper.readings() <= before + session.readings.size());
    } else {
      require(mapper.readings() == before);  // refused as a whole
    }
  });
}

}  // namespace sfw::fuzz
