#include "app/editor/workers/poke_film.h"

#include "core/exchange/image_file.h"
#include "core/render/organ_scene.h"
#include "core/support/errors.h"
#include "core/support/file_io.h"
#include "tests/app/editor/workers/poked_organ.h"
#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>
#include <QImage>

#include <cstring>

using namespace esm;

namespace {

/// A moment of an organ at rest, then the whole of it two centimetres to the right.
PokeFilm shortFilm() {
    const Project project = pokedOrgan(300);
    PokeMotion motion{project, {}, {}};
    for (const double shift : {0.0, 0.02}) {
        PokePicture picture{motion.pictures.empty() ? 0 : 1.0 / pokePicturesPerSecond, {}, {}};
        for (const Eigen::Vector3d& rest : project.network->restPositions)
            picture.positions.push_back((rest + Eigen::Vector3d(shift, 0, 0)).cast<float>());
        motion.pictures.push_back(picture);
    }
    const RenderScene scene = organScene(project.mesh, project.network, project.texture.baseColour);
    const auto moves = std::make_shared<const PokeMotion>(motion);
    return {scene, framedCamera(organBox(*project.mesh, *project.network), StandardView::Front, 4.0 / 3),
            4.0 / 3, moves, moves};
}

QImage pictureOf(const std::filesystem::path& file) {
    return QImage(QString::fromStdString(file.string()));
}

std::uint32_t numberAt(const Bytes& bytes, std::size_t place) {
    std::uint32_t number = 0;
    std::memcpy(&number, bytes.data() + place, sizeof number);
    return number;
}

TEST(PokeFilm, PicturesShowBothOrgansAndTheMotion) {
    const TemporaryFolder folder;
    writeFilmPictures(shortFilm(), folder / "poke.png");
    const QImage first = pictureOf(folder / "poke-0001.png"), second = pictureOf(folder / "poke-0002.png");
    EXPECT_EQ(first.size(), QSize(1920, 720));
    EXPECT_FALSE(std::filesystem::exists(folder / "poke-0003.png"));
    // Below the captions both halves are the same organ.
    const QRect left(0, 60, 960, 660), right(960, 60, 960, 660);
    EXPECT_EQ(first.copy(left), first.copy(right));
    EXPECT_NE(first.copy(left), second.copy(left));
}

TEST(PokeFilm, AloneItIsAsWideAsOneOrgan) {
    const TemporaryFolder folder;
    PokeFilm film = shortFilm();
    film.before = nullptr;
    writeFilmPictures(film, folder / "poke.png");
    EXPECT_EQ(pictureOf(folder / "poke-0001.png").size(), QSize(960, 720));
}

TEST(PokeFilm, IsMotionJpegOfAllPictures) {
    const TemporaryFolder folder;
    writeFilm(shortFilm(), folder / "poke.avi");
    const Bytes bytes = readFile(folder / "poke.avi");
    ASSERT_GT(bytes.size(), 1000U);
    EXPECT_EQ(std::memcmp(bytes.data(), "RIFF", 4), 0);
    EXPECT_EQ(std::memcmp(bytes.data() + 8, "AVI ", 4), 0);
    // The main header begins at byte 32: microseconds of a picture, and from 16 bytes on how many there are.
    EXPECT_NEAR(numberAt(bytes, 32), 1e6 / 30, 1);
    EXPECT_EQ(numberAt(bytes, 32 + 16), 2U);
    EXPECT_EQ(numberAt(bytes, 32 + 32), 1920U);
}

TEST(PokeFilm, LeavesOthersPicturesAloneAndNoneOfItsOwnWhenCancelled) {
    const TemporaryFolder folder;
    writeFileAtomically(folder / "poke-0002.png", std::string("another"));
    EXPECT_THROW(writeFilmPictures(shortFilm(), folder / "poke.png"), FileError);
    EXPECT_FALSE(std::filesystem::exists(folder / "poke-0001.png"));
    EXPECT_EQ(readFile(folder / "poke-0002.png").size(), 7U);
    std::filesystem::remove(folder / "poke-0002.png");
    const Progress oneOnly = [](double done) { return done < 0.4; };
    EXPECT_THROW(writeFilmPictures(shortFilm(), folder / "poke.png", oneOnly), Cancelled);
    EXPECT_THROW(writeFilm(shortFilm(), folder / "poke.avi", oneOnly), Cancelled);
    EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
    EXPECT_THROW(writeFilmPictures(shortFilm(), folder / "none" / "poke.png"), FileError);
    bool hasBegun = false;
    const Progress noteBegin = [&](double) { return hasBegun = true; };
    EXPECT_THROW(writeFilm(shortFilm(), folder / "none" / "poke.avi", noteBegin), FileError);
    EXPECT_FALSE(hasBegun) << "the user waits for no picture in vain";
}

} // namespace
