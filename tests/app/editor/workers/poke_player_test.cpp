#include "app/editor/workers/poke_player.h"

#include "tests/support/eventually.h"

using namespace esm;

TEST(PokePlayer, ShowsNothingOfNothing) {
    PokePlayer player;
    player.play();
    EXPECT_FALSE(player.isShown());
    player.showMoment(1);
    EXPECT_FALSE(player.isShown());
}

TEST(PokePlayer, PlaysToTheEndAndThenFromTheStart) {
    PokePlayer player;
    player.setDuration(0.05);
    player.play();
    EXPECT_TRUE(player.isShown());
    EXPECT_TRUE(player.isPlaying());
    ESM_EVENTUALLY(!player.isPlaying());
    EXPECT_DOUBLE_EQ(player.time(), 0.05);
    EXPECT_TRUE(player.isShown()) << "the end stays to be looked at";
    player.play();
    EXPECT_LT(player.time(), 0.05);
    player.leave();
    EXPECT_FALSE(player.isShown());
    EXPECT_FALSE(player.isPlaying());
}

TEST(PokePlayer, AMomentStaysAndLiesWithinTheMotion) {
    PokePlayer player;
    player.setDuration(2);
    player.play();
    player.showMoment(1.5);
    EXPECT_FALSE(player.isPlaying());
    EXPECT_DOUBLE_EQ(player.time(), 1.5);
    player.showMoment(9);
    EXPECT_DOUBLE_EQ(player.time(), 2);
    player.setDuration(1);
    EXPECT_DOUBLE_EQ(player.time(), 1) << "another motion is shorter";
    player.setDuration(0);
    EXPECT_FALSE(player.isShown());
}
