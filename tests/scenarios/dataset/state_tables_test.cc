// SPDX-License-Identifier: Apache-2.0
#include "scenarios/dataset/state_tables.h"

#include <cmath>
#include <stdexcept>

#include "scenarios/dataset/csv.h"
#include "tests/scenarios/dataset/bytes.h"

namespace horopter::scenarios {
namespace {

using testing::HasSubstr;

hardware::Pose SomePose(double angle) {
  hardware::Pose X = hardware::Pose::Identity();
  X.translation() << 0.1, -2.0 / 3, 1e-9;
  X.linear() = Eigen::AngleAxisd(angle, Eigen::Vector3d(1, 2, -3).normalized()).toRotationMatrix();
  return X;
}

TEST(StateTables, PosesReadBack) {
  const std::vector<sim::BodyPose> bodies = {{"base", SomePose(0.3)},
                                             {"a, \"b\"", SomePose(-3.1)}};
  const std::string text = EncodePoses(bodies);
  EXPECT_EQ(text.substr(0, text.find('\n')), "body,x_m,y_m,z_m,qw,qx,qy,qz");
  const auto read = DecodePoses(text, "poses.csv");
  ASSERT_EQ(read.size(), 2u);
  for (int i = 0; i < 2; ++i) {
    EXPECT_EQ(read[i].body, bodies[i].body);
    EXPECT_EQ(read[i].X_WB.translation(), bodies[i].X_WB.translation());
    EXPECT_LT((read[i].X_WB.linear() - bodies[i].X_WB.linear()).norm(), 3e-15);
  }
}

TEST(StateTables, QuaternionsHaveANonNegativeW) {
  const std::string text = EncodePoses({{"b", SomePose(3.5)}});
  EXPECT_EQ(text.find(",-", text.find("e-09") + 1), text.find(",-", text.find("e-09") + 5))
      << "the first negative number comes after w";
  EXPECT_GT(std::stod(text.substr(text.find("e-09,") + 5)), 0);
}

TEST(StateTables, AreTheTextTheySay) {
  EXPECT_EQ(EncodeJoints({{"pan", sim::JointKind::kHinge, 0.5, -1}}),
            "joint,kind,position,velocity\npan,hinge,0.5,-1\n");
  EXPECT_EQ(EncodeContacts({{"floor", "hull", "world", "base", -1e-4, {1, 2, 0}, {0, 0, 1}}}),
            "geom1,geom2,body1,body2,distance_m,x_m,y_m,z_m,normal_x,normal_y,normal_z\n"
            "floor,hull,world,base,-0.0001,1,2,0,0,0,1\n");
  EXPECT_EQ(EncodePoses({{"b", hardware::Pose::Identity()}}),
            "body,x_m,y_m,z_m,qw,qx,qy,qz\nb,0,0,0,1,0,0,0\n");
}

TEST(StateTables, JointsReadBackExactly) {
  const std::vector<sim::JointReading> joints = {{"pan", sim::JointKind::kHinge, M_PI / 7, -1e-17},
                                                 {"lift", sim::JointKind::kSlide, 0.1, 0}};
  const auto read = DecodeJoints(EncodeJoints(joints), "joints.csv");
  ASSERT_EQ(read.size(), 2u);
  for (int i = 0; i < 2; ++i) {
    EXPECT_EQ(read[i].joint, joints[i].joint);
    EXPECT_EQ(read[i].kind, joints[i].kind);
    EXPECT_EQ(read[i].position, joints[i].position);
    EXPECT_EQ(read[i].velocity, joints[i].velocity);
  }
}

TEST(StateTables, ContactsReadBackExactlyAndNoneIsAHeader) {
  const std::vector<sim::Contact> contacts = {
      {"floor", "hull", "world", "base", -1.0 / 3, {1, 2, 3}, {0.6, 0, 0.8}}};
  const auto read = DecodeContacts(EncodeContacts(contacts), "contacts.csv");
  ASSERT_EQ(read.size(), 1u);
  EXPECT_EQ(read[0].body2, "base");
  EXPECT_EQ(read[0].distance_m, -1.0 / 3);
  EXPECT_EQ(read[0].p_W, Eigen::Vector3d(1, 2, 3));
  EXPECT_EQ(read[0].normal_W, Eigen::Vector3d(0.6, 0, 0.8));
  EXPECT_TRUE(DecodeContacts(EncodeContacts({}), "contacts.csv").empty());
}

TEST(StateTables, NameFileLineAndField) {
  const auto joints = [](const std::string& rows) {
    return FormatComplaint([&] { DecodeJoints("joint,kind,position,velocity\n" + rows, "j.csv"); });
  };
  EXPECT_THAT(FormatComplaint([] { DecodeJoints("", "j.csv"); }), HasSubstr("j.csv:1: the first"));
  EXPECT_THAT(FormatComplaint([] { DecodeJoints("joint,kind\n", "j.csv"); }),
              HasSubstr("is not 'joint,kind,position,velocity'"));
  EXPECT_THAT(joints("a,hinge,0,0\nb,hinge,0\n"),
              HasSubstr("j.csv:3: 3 fields, the header names 4"));
  EXPECT_THAT(joints("a,hinge,0,0\nb,hinge,zero,0\n"), HasSubstr("j.csv:3: 'zero' is no number"));
  EXPECT_THAT(joints("a,hinge,,0\n"), HasSubstr("'' is no number"));
  EXPECT_THAT(joints("a,hinge,0,0x\n"), HasSubstr("'0x' is no number"));
  EXPECT_THAT(joints("a,ball,0,0\n"), HasSubstr("'ball' is neither hinge nor slide"));
  EXPECT_THAT(joints("\"x\ny\",hinge,0,0\nb,ball,0,0\n"), HasSubstr("j.csv:4: 'ball'"));
  EXPECT_THAT(joints("a,hinge,0,0"), HasSubstr("j.csv:2: truncated"));
  EXPECT_THAT(joints("\"a,hinge,0,0\n"), HasSubstr("nor has its quote"));
  EXPECT_THAT(FormatComplaint(
                  [] { DecodePoses("body,x_m,y_m,z_m,qw,qx,qy,qz\nb,0,0,0,1,1,0,0\n", "p.csv"); }),
              HasSubstr("p.csv:2: '1' begins a quaternion that is not of unit length"));
}

}  // namespace
}  // namespace horopter::scenarios
