#!/usr/bin/env bash
# Shows that calls of services in roscpp 1.15.15 report failure though the service was carried out.
#
# 1. Of many calls with ros::service::call() on a busy machine a few return false. The server has
#    carried out each of them, and answered. (ServiceClient::call() of a client that is not
#    persistent does the same.) The server closes such a connection after its answer, and the client
#    can see that end before it has read the answer.
# 2. With a persistent client, even a new one for each call, no answer is lost: there the client
#    closes the connection.
#
# So a caller that repeats a failed call does the work twice, and one that reports the failure is
# wrong. See https://github.com/ros/ros_comm/issues/1976 for the cause.
#
# Usage: roscpp_loses_service_answers.sh
# Needs Debian 12 with g++ and up-to-date package lists. Downloads the pinned packages, and those of
# their libraries that this machine lacks (at most 90 MB), and unpacks all into a temporary folder.
# Takes up to five minutes. Exits 0 if all is as above, 1 if roscpp behaves otherwise, 2 if it cannot
# be run.
set -euo pipefail

roscpp_version=1.15.15+ds-2
calls=10000    # of each client in one round
clients=4      # at once, so that the machine is busy
rounds=20      # at most, until an answer is lost

# shellcheck source=findings/packages.bash
source "$(dirname "${BASH_SOURCE[0]}")/packages.bash"

enter_temporary_folder
stop_all() {
  # shellcheck disable=SC2046  # a list of numbers
  kill $(jobs -p) 2> /dev/null || true
  wait
  rm -r "$folder"
}
trap stop_all EXIT

pinned="libroscpp-dev=$roscpp_version libroscpp4d=$roscpp_version python3-rosmaster=$roscpp_version"
# shellcheck disable=SC2086  # a list of words
missing=$(apt-get install --simulate --no-install-recommends $pinned libstd-srvs-dev 2> log |
  awk '$1 == "Inst" { print $2 }' | grep -vxE 'libroscpp-dev|libroscpp4d|python3-rosmaster' || true)
# shellcheck disable=SC2086  # a list of words
unpack_packages $pinned $missing

cat > calls.cpp <<'CPP'
#include <ros/ros.h>
#include <std_srvs/Trigger.h>

#include <cstdio>
#include <cstdlib>
#include <string>

// Usage: calls serve | calls plain COUNT | calls persistent COUNT
int main(int argc, char** argv) {
  const std::string mode = argv[1];
  ros::init(argc, argv, mode, ros::init_options::AnonymousName);
  ros::NodeHandle node;
  if (mode == "serve") {
    long served = 0;
    ros::ServiceServer work = node.advertiseService<std_srvs::TriggerRequest, std_srvs::TriggerResponse>(
        "work", [&](std_srvs::TriggerRequest&, std_srvs::TriggerResponse& response) {
          ++served;
          response.success = 1;
          return true;
        });
    ros::spin();
    std::printf("%ld\n", served);
    return 0;
  }
  ros::service::waitForService("work");
  int failed = 0;
  for (int i = 0; i < std::atoi(argv[2]); ++i) {
    std_srvs::Trigger call;
    const bool is_answered = mode == "plain"
                                 ? ros::service::call("work", call)
                                 : node.serviceClient<std_srvs::Trigger>("work", true).call(call);
    failed += is_answered ? 0 : 1;
  }
  std::printf("%d\n", failed);
}
CPP

libraries=usr/lib/$(g++ -print-multiarch)
export LD_LIBRARY_PATH=$folder/$libraries PYTHONPATH=$folder/usr/lib/python3/dist-packages
g++ -std=c++17 -isystem usr/include calls.cpp -o calls -L"$libraries" -Wl,--allow-shlib-undefined \
  "$libraries"/libroscpp.so -lroscpp_serialization -lrosconsole -lrostime -lboost_system \
  -lboost_thread 2> log || cannot_run "g++: $(grep -m 1 error log)"
lacking=$(ldd calls | awk '/not found/ { print $1 }')
[[ -z $lacking ]] || cannot_run "libraries are missing: ${lacking//$'\n'/ }"

port=$(/usr/bin/python3 -c 'import socket; s = socket.socket(); s.bind(("127.0.0.1", 0)); print(s.getsockname()[1])')
export ROS_MASTER_URI=http://127.0.0.1:$port ROS_IP=127.0.0.1 ROS_LOG_DIR=$folder/log_of_ros
/usr/bin/python3 -c "import rosmaster; rosmaster.rosmaster_main(['rosmaster', '--core', '-p', '$port'])" \
  > master.log 2>&1 &
for ((i = 0; ; ++i)); do
  (: > "/dev/tcp/127.0.0.1/$port") 2> /dev/null && break
  ((i < 100)) || cannot_run "the ROS master does not start: $(tail -n 1 master.log)"
  sleep 0.1
done
echo "roscpp $roscpp_version"

# Sets made, failed and served to the numbers of calls.
run() {
  local mode=$1 pids=()
  ./calls serve > served 2> /dev/null &
  local server=$!
  for ((client = 0; client < clients; ++client)); do
    ./calls "$mode" "$calls" > "failed_$client" 2> /dev/null &
    pids+=($!)
  done
  wait "${pids[@]}"
  kill -INT "$server"
  wait "$server" || true
  made=$((clients * calls))
  failed=$(cat failed_* | awk '{ sum += $1 } END { print sum }')
  served=$(cat served)
}

as_described=yes
for ((round = 1; round <= rounds; ++round)); do
  run plain
  echo "plain: $made calls, $served carried out, $failed reported as failed"
  ((failed == 0)) || break
done
((failed > 0)) || as_described=no
((served > made - failed)) || as_described=no
run persistent
echo "persistent: $made calls, $served carried out, $failed reported as failed"
((failed == 0 && served == made)) || as_described=no

if [[ $as_described == yes ]]; then
  echo 'All is as described at the top of this script.'
else
  echo 'roscpp behaves otherwise than described at the top of this script.' >&2
  exit 1
fi
