#include "tests/app/editor/workers/poked_organ.h"

#include <gtest/gtest.h>

#include <algorithm>

using namespace esm;

namespace {

double largestForce(const PokeMotion& motion) {
    double most = 0;
    for (const PokePicture& picture : motion.pictures)
        most = std::max(most, picture.force);
    return most;
}

Project firmer(Project project) {
    for (Region& region : project.regions)
        region.held.springConstant = 3 * region.held.springConstant.value_or(100);
    return project;
}

} // namespace

TEST(PokeMotion, EveryPictureIsFoundAtItsTime) {
    for (int number = 0; number < 30 * pokePicturesPerSecond; ++number)
        EXPECT_EQ(pictureNumberAt(static_cast<double>(number) / pokePicturesPerSecond), number);
}

TEST(Poke, WhatActsLastsUntilTheNextMoment) {
    Poke poke;
    poke.moments = {{0.1, {Pull{1, {0, 0, 1}}, {}, false}}, {0.3, {}}};
    EXPECT_FALSE(loadsAt(poke, 0).pull);
    EXPECT_TRUE(loadsAt(poke, 0.1).pull);
    EXPECT_TRUE(loadsAt(poke, 0.29).pull);
    EXPECT_FALSE(loadsAt(poke, 0.3).pull);
    EXPECT_FALSE(loadsAt(poke, 9).pull);
}

TEST(Poke, ARunThatWentBackIsWrittenDownAnew) {
    PokeRecorder recorder(nullptr);
    const PreviewLoads pull{Pull{1, {0, 0, 1}}, {}, false};
    recorder.note(0, {});
    recorder.note(0.1, pull);
    recorder.note(0.2, pull);
    EXPECT_EQ(recorder.poke().moments.size(), 2U) << "what stays the same is one moment";
    recorder.note(0.1, {});
    recorder.goOn(0.12);
    ASSERT_EQ(recorder.poke().moments.size(), 1U);
    EXPECT_FALSE(loadsAt(recorder.poke(), 0.11).pull);
    EXPECT_DOUBLE_EQ(recorder.poke().duration, 0.12);
}

TEST(PokeMotion, TheSameOrganMovesAsItDidUnderTheHand) {
    const Project project = pokedOrgan();
    const RecordedRun recorded(project);
    const Poke& poke = recorded.recorder.poke();
    PreviewRun again;
    ASSERT_TRUE(again.take(prepareProject(project)));
    ASSERT_TRUE(again.follow(poke, poke.duration));
    EXPECT_EQ(again.time(), recorded.run.time());
    EXPECT_EQ(again.positions(), recorded.run.positions()) << "to the last bit";

    const PokeMotion motion = motionUnder(poke, project);
    EXPECT_EQ(motion.failure, "");
    EXPECT_EQ(motion.pictures.size(), std::size_t(std::lround(30 * poke.duration)) + 1);
    EXPECT_EQ(motion.pictures.front().force, 0);
    EXPECT_GT(largestForce(motion), 0.01);
    EXPECT_NEAR(pictureAt(motion, 0.45).displacement, std::hypot(0.01, 0.02), 0.002);
    EXPECT_EQ(motion.pictures.back().force, 0) << "the hand has let go";
    EXPECT_EQ(&pictureAt(motion, 99), &motion.pictures.back());
}

TEST(PokeMotion, FirmerTissueTakesMoreForce) {
    const Project project = pokedOrgan();
    const Poke poke = RecordedRun(project).recorder.poke();
    EXPECT_GT(largestForce(motionUnder(poke, firmer(project))),
              1.2 * largestForce(motionUnder(poke, project)));
}

TEST(PokeMotion, AnotherNetOfTheOrganIsPokedAtTheSamePlace) {
    const Project fine = pokedOrgan(), coarse = pokedOrgan(300);
    const Poke poke = RecordedRun(fine).recorder.poke(), carried = carriedOver(poke, coarse.network);
    ASSERT_EQ(carried.moments.size(), poke.moments.size());
    const auto isPull = [](const HandMoment& moment) { return moment.loads.pull.has_value(); };
    const auto from = std::find_if(poke.moments.begin(), poke.moments.end(), isPull);
    const auto to = std::find_if(carried.moments.begin(), carried.moments.end(), isPull);
    ASSERT_NE(from, poke.moments.end());
    const Eigen::Vector3d was = fine.network->restPositions[from->loads.pull->node];
    const Eigen::Vector3d is = coarse.network->restPositions[to->loads.pull->node];
    EXPECT_LT((was - is).norm(), 0.02);
    EXPECT_LT(((from->loads.pull->target - was) - (to->loads.pull->target - is)).norm(), 1e-12)
        << "it goes as far";
    const PokeMotion motion = motionUnder(poke, coarse);
    EXPECT_EQ(motion.failure, "");
    EXPECT_EQ(motion.pictures.back().positions.size(), coarse.network->restPositions.size());
    EXPECT_GT(largestForce(motion), 0);
}

TEST(PokeMotion, CanBeCancelledAndSaysWhyAnOrganDoesNotMove) {
    const Project project = pokedOrgan();
    const Poke poke = RecordedRun(project).recorder.poke();
    EXPECT_THROW(motionUnder(poke, project, [](double done) { return done < 0.5; }), Cancelled);
    Project refused = project;
    refused.base.mass = -1;
    EXPECT_THROW(motionUnder(poke, refused), InvalidModel);
}
