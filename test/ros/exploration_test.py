#!/usr/bin/env python3
"""Lets the exploration drive the simulated robot by bumpers alone, and send goals to move_base.

Usage: exploration_test.py RESULT.xml EXPLORATION_NODE
"""

import functools
import math
import os
import pathlib
import sys
import threading
import traceback
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "support"))

import junit  # noqa: E402
from ros_session import RosSession, wait_until  # noqa: E402

START = (3.0, 3.65)  # of the demo's route [m]


class Listener:
    """What the simulator, the mapper and the exploration say."""

    def __init__(self, session):
        os.environ["ROS_MASTER_URI"] = session.uri
        os.environ["ROS_IP"] = "127.0.0.1"
        import rospy
        from diagnostic_msgs.msg import DiagnosticArray
        from geometry_msgs.msg import Twist
        from nav_msgs.msg import OccupancyGrid, Odometry
        from sensor_msgs.msg import PointCloud2
        from std_msgs.msg import Bool
        from visualization_msgs.msg import MarkerArray
        self.rospy = rospy
        rospy.init_node("listener", disable_signals=True)
        self.pose, self.driven, self.touches, self.free_m2 = None, 0.0, 0, 0.0
        self.finished, self.status, self.command, self.goals = False, "", None, 0
        rospy.Subscriber("odom", Odometry, self.take_odometry)
        rospy.Subscriber("contact_points", PointCloud2, self.take_touch)
        rospy.Subscriber("map", OccupancyGrid, self.take_map)
        rospy.Subscriber("exploration/finished", Bool, self.take_end)
        rospy.Subscriber("exploration", MarkerArray, self.take_markers)
        rospy.Subscriber("cmd_vel", Twist, self.take_command)
        rospy.Subscriber("/diagnostics", DiagnosticArray, self.take_diagnostics)

    def take_odometry(self, message):
        at = message.pose.pose.position
        if self.pose:
            self.driven += math.dist(self.pose, (at.x, at.y))
        self.pose = (at.x, at.y)

    def take_touch(self, cloud):
        self.touches += cloud.width > 0

    def take_map(self, grid):
        self.free_m2 = sum(value == 0 for value in grid.data) * grid.info.resolution ** 2
        self.info = grid.info

    def has_on_map(self, at):
        low = self.info.origin.position
        return (0.0 < at[0] - low.x < self.info.width * self.info.resolution
                and 0.0 < at[1] - low.y < self.info.height * self.info.resolution)

    def take_end(self, message):
        self.finished = message.data

    def take_markers(self, array):
        self.goals = sum(marker.ns == "gains" and marker.action == 0 for marker in array.markers)

    def take_command(self, twist):
        self.command = twist

    def take_diagnostics(self, array):
        for status in array.status:
            if status.name.startswith("exploration"):
                self.status = status.message

    def call(self, service):
        from std_srvs.srv import Trigger
        return self.rospy.ServiceProxy("exploration/" + service, Trigger)()


class MoveBase:
    """A stand-in for move_base, which Debian lacks: it notes goals, and answers as it is told."""

    def __init__(self, rospy):
        from actionlib_msgs.msg import GoalID, GoalStatus, GoalStatusArray
        from move_base_msgs.msg import (MoveBaseActionFeedback, MoveBaseActionGoal,
                                        MoveBaseActionResult)
        self.rospy, self.status_type, self.array_type = rospy, GoalStatus, GoalStatusArray
        self.result_type = MoveBaseActionResult
        self.lock, self.goals, self.cancelled = threading.RLock(), [], []
        self.active = None
        self.results = rospy.Publisher("move_base/result", MoveBaseActionResult, queue_size=10)
        self.statuses = rospy.Publisher("move_base/status", GoalStatusArray, queue_size=10)
        self.feedback = rospy.Publisher("move_base/feedback", MoveBaseActionFeedback, queue_size=10)
        rospy.Subscriber("move_base/goal", MoveBaseActionGoal, self.take_goal)
        rospy.Subscriber("move_base/cancel", GoalID, self.take_cancel)
        threading.Thread(target=self.report, daemon=True).start()

    def report(self):
        while not self.rospy.is_shutdown():
            self.publish_status()
            threading.Event().wait(0.1)

    def publish_status(self):
        with self.lock:
            array = self.array_type()
            if self.active:
                array.status_list = [self.status_type(goal_id=self.active.goal_id,
                                                      status=self.status_type.ACTIVE)]
            self.statuses.publish(array)

    def take_goal(self, goal):
        with self.lock:
            at = goal.goal.target_pose.pose.position
            self.goals.append((at.x, at.y))
            self.active = goal
        self.publish_status()

    def take_cancel(self, goal_id):
        with self.lock:
            self.cancelled.append(goal_id.id)
            if self.active:
                self.answer(self.status_type.PREEMPTED)

    def answer(self, status):
        with self.lock:
            result = self.result_type()
            result.status.goal_id = self.active.goal_id
            result.status.status = status
            self.active = None
            self.results.publish(result)


def in_own_process(test):
    """Runs the test in a child with a master and a rospy node of its own.

    A process can be a node only once, and connections of one test must not reach the next.
    """
    @functools.wraps(test)
    def run(self):
        reading, writing = os.pipe()
        child = os.fork()
        if child == 0:
            text = ""
            try:
                with RosSession() as session:
                    self.session, self.listener = session, Listener(session)
                    test(self)
            except BaseException:
                text = traceback.format_exc()
            with os.fdopen(writing, "w", encoding="utf-8") as pipe:
                pipe.write(text)
            os._exit(0)
        os.close(writing)
        with os.fdopen(reading, encoding="utf-8") as pipe:
            text = pipe.read()
        _, status = os.waitpid(child, 0)
        if text or status:
            self.fail(text or "the test's process ended with status %d" % status)
    return run


class Exploration(unittest.TestCase):
    def launch(self, *arguments):
        return self.session.start("explore", "roslaunch", "structure_from_wifi", "explore.launch",
                                  "rviz:=false", "time_scale:=5",
                                  "save_directory:=%s" % (self.session.folder / "maps"),
                                  *arguments)

    def wait(self, condition, seconds, what):
        """Waits for the condition; a failure tells what the processes wrote."""
        try:
            wait_until(condition, seconds, what)
        except Exception as error:
            said = "\n".join(self.say(process) for process in self.session.processes)
            raise AssertionError("%s\nstatus: %s\n%s" % (error, self.listener.status, said))

    def say(self, process):
        return self.session.text_of(process)[-3000:]

    @in_own_process
    def test_a_robot_with_bumpers_explores_and_returns(self):
        process = self.launch("time_budget:=90")
        hear = self.listener
        self.wait(lambda: hear.driven > 5.0, 90, "the robot's drive")
        self.assertGreater(hear.goals, 0, "no goals for rviz")
        self.assertEqual(hear.status, "The robot explores.")
        self.wait(lambda: hear.finished, 120, "the end of the exploration")
        self.assertGreater(hear.touches, 0)
        self.assertGreater(hear.free_m2, 8.0)
        self.assertLess(math.dist(hear.pose, START), 0.6, "the robot did not return")
        self.assertIn("the budget is used up", self.say(process))
        self.assertFalse(hear.call("start").success)

    @in_own_process
    def test_stop_halts_the_robot_and_start_goes_on(self):
        self.launch("autostart:=false")
        hear = self.listener
        self.wait(lambda: "stands" in hear.status, 90, "the exploration's start")
        self.wait(lambda: hear.pose, 60, "the simulator's start")
        self.assertLess(hear.driven, 0.01)
        self.assertTrue(hear.call("start").success)
        self.wait(lambda: hear.driven > 1.0, 90, "the robot's drive")
        self.assertTrue(hear.call("stop").success)
        self.wait(lambda: hear.command and hear.command.linear.x == 0.0, 10, "a command to stop")
        threading.Event().wait(1.0)  # five seconds of the simulation, to brake
        driven = hear.driven
        threading.Event().wait(2.0)
        self.assertLess(hear.driven - driven, 0.01)
        self.assertTrue(hear.call("start").success)
        self.wait(lambda: hear.driven > driven + 1.0, 60, "the robot's drive after a stop")

    def test_a_bad_parameter_is_named(self):
        with RosSession() as session:
            node = session.start("node", sys.argv[1], "_driver:=legs", "_speed:=0", "_view:=many")
            self.assertNotEqual(node.wait(30), 0)
            text = session.text_of(node)
        for problem in ("driver must be bumpers or move_base; it is 'legs'", "speed must lie in",
                        "view must be a number"):
            self.assertIn(problem, text)

    @in_own_process
    def test_goals_go_to_move_base(self):
        from std_msgs.msg import Bool
        rospy = self.listener.rospy
        move_base = MoveBase(rospy)
        contact = rospy.Publisher("contact", Bool, queue_size=1)
        self.session.set_parameter("/exploration/driver", "move_base")
        # Launch files set it after this, and a node that starts earlier would miss it.
        self.session.set_parameter("/use_sim_time", True)
        # navigate.launch needs a real move_base, so the nodes start one by one.
        hear = self.listener
        self.session.start("demo", "roslaunch", "structure_from_wifi", "demo.launch",
                           "rviz:=false", "drive:=cmd_vel", "time_scale:=2")
        self.session.start("node", sys.argv[1], "__name:=exploration")
        self.wait(lambda: move_base.goals, 90, "the first goal")
        first = move_base.goals[0]
        # move_base makes no plan to a goal off its map, and the first map is small.
        self.assertTrue(hear.has_on_map(first), "the goal %s is off the map" % (first,))
        # A goal that fails is not sent again.
        move_base.answer(move_base.status_type.ABORTED)
        self.wait(lambda: len(move_base.goals) > 1, 60, "a goal after one that failed")
        self.assertGreater(math.dist(first, move_base.goals[1]), 0.5)
        # After a touch the goal is cancelled, and the robot drives backwards.
        self.assertFalse(move_base.cancelled)
        contact.publish(True)
        self.wait(lambda: move_base.cancelled, 30, "the end of a goal after a touch")
        self.wait(lambda: hear.command and hear.command.linear.x < 0.0, 30, "the way back")
        contact.publish(False)
        self.wait(lambda: len(move_base.goals) > 2, 60, "a goal after a touch")
        # move_base that holds a goal and does not drive is wedged.
        hear.command = None  # that after the touch
        cancelled, goals = len(move_base.cancelled), len(move_base.goals)
        self.wait(lambda: len(move_base.cancelled) > cancelled, 60, "the end of a wedged goal")
        self.wait(lambda: hear.command and hear.command.linear.x < 0.0, 30, "the way back")
        self.wait(lambda: len(move_base.goals) > goals, 60, "a goal after a wedged one")

    @in_own_process
    def test_a_robot_that_nothing_moves_is_stuck(self):
        MoveBase(self.listener.rospy)
        self.session.set_parameter("/exploration/driver", "move_base")
        self.session.set_parameter("/use_sim_time", True)
        self.session.start("demo", "roslaunch", "structure_from_wifi", "demo.launch",
                           "rviz:=false", "drive:=cmd_vel", "time_scale:=8")
        # Nobody hears the commands, and move_base answers nothing.
        self.session.start("node", sys.argv[1], "__name:=exploration", "cmd_vel:=nowhere")
        self.wait(lambda: "The robot is stuck" in self.listener.status, 150, "the stuck robot")
        self.assertLess(self.listener.driven, 0.1)


if __name__ == "__main__":
    junit.run()
