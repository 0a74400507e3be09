#include "app/editor/workers/poke_film.h"

#include "app/editor/workers/poke_scene.h"
#include "core/decoding/decoder_program.h"
#include "core/offscreen/offscreen.h"
#include "core/support/atomic_file.h"
#include "core/support/errors.h"
#include "core/support/file_io.h"
#include "widgets/inputs/number_text.h"

#include <QImage>
#include <QPainter>
#include <QProcess>
#include <QTemporaryDir>

#include <algorithm>
#include <cmath>

namespace esm {

namespace {

namespace fs = std::filesystem;

constexpr int filmHeight = 720;                           // pixels
constexpr int leastFilmWidth = 480, mostFilmWidth = 1280; // of one organ
constexpr int captionHeight = 22, captionPlace = 16;
constexpr double encodingShare = 0.1; // of the work
constexpr int encoderNews = 50;       // ms, after which it is asked whether to go on

/// As the view's, but even, as encoders want it.
int widthOf(const PokeFilm& film) {
    const int width = 2 * static_cast<int>(std::lround(film.aspect * filmHeight / 2));
    return std::clamp(width, leastFilmWidth, mostFilmWidth);
}

QImage pictureIn(const PokeFilm& film, const PokeMotion& motion, double time) {
    const Image image =
        renderOffscreen(sceneAt(film.scene, motion, time), film.camera, widthOf(film), filmHeight);
    return QImage(image.pixels.data(), image.width, image.height, QImage::Format_RGBA8888)
        .convertToFormat(QImage::Format_RGB32);
}

void caption(QPainter& painter, int left, const QString& text) {
    painter.drawText(QPoint(left + captionPlace, captionPlace + captionHeight), text);
}

/// What was before stands at the left, as in the window.
QImage filmPicture(const PokeFilm& film, double time) {
    const int width = widthOf(film);
    QImage picture((film.before ? 2 : 1) * width, filmHeight, QImage::Format_RGB32);
    QPainter painter(&picture);
    painter.setPen(Qt::white);
    QFont font = painter.font();
    font.setPixelSize(captionHeight);
    painter.setFont(font);
    const int left = film.before ? width : 0;
    const QString seconds = decimalText(time, 2) + QStringLiteral(" s");
    painter.drawImage(left, 0, pictureIn(film, *film.now, time));
    if (film.before) painter.drawImage(0, 0, pictureIn(film, *film.before, time));
    if (film.before) caption(painter, 0, QObject::tr("before"));
    caption(painter, left, film.before ? QObject::tr("now, %1").arg(seconds) : seconds);
    return picture;
}

fs::path numbered(const fs::path& start, std::size_t number) {
    const QString ending = QStringLiteral("%1.png").arg(number, 4, 10, QLatin1Char('0'));
    return fs::path(start.string() + ending.toStdString());
}

std::size_t pictureCount(const PokeFilm& film) {
    return std::max(film.now->pictures.size(), film.before ? film.before->pictures.size() : 0);
}

void writePictures(const PokeFilm& film, const fs::path& start, const Progress& progress) {
    const std::size_t count = pictureCount(film);
    for (std::size_t i = 0; i < count; ++i) {
        reportProgress(progress, static_cast<double>(i) / static_cast<double>(count));
        const fs::path file = numbered(start, i + 1);
        const QImage picture = filmPicture(film, static_cast<double>(i) / pokePicturesPerSecond);
        if (!picture.save(QString::fromStdString(file.string()), "PNG"))
            throw FileError(file, "cannot be written: is there room on the disk, and may you write there?");
    }
    reportProgress(progress, 1);
}

void encodeFilm(const fs::path& start, std::size_t pictures, const fs::path& file, const Progress& progress) {
    const fs::path program = decoderProgram().parent_path() / "esm-film"; // installed beside each other
    if (!fs::exists(program))
        throw FileError(
            program, "is not there, without which no film can be made; install it, or save pictures (.png)");
    QProcess encoder;
    encoder.start(QString::fromStdString(program.string()),
                  {QString::fromStdString(start.string()), QString::number(pictures),
                   QString::number(pokePicturesPerSecond), QString::fromStdString(file.string())});
    while (encoder.state() != QProcess::NotRunning && !encoder.waitForFinished(encoderNews)) {
        if (!progress || progress(0)) continue;
        encoder.kill();
        encoder.waitForFinished();
        throw Cancelled();
    }
    if (encoder.error() == QProcess::FailedToStart || encoder.exitStatus() != QProcess::NormalExit ||
        encoder.exitCode() != 0)
        throw FileError(program, "made no film of the pictures: " +
                                     encoder.readAllStandardError().trimmed().toStdString());
}

} // namespace

void writeFilmPictures(const PokeFilm& film, const fs::path& file, const Progress& progress) {
    const fs::path start = file.parent_path() / (file.stem().string() + "-");
    for (std::size_t i = 0; i < pictureCount(film); ++i)
        if (fs::exists(numbered(start, i + 1)))
            throw FileError(numbered(start, i + 1), "is there already; choose another name");
    try {
        writePictures(film, start, progress);
    } catch (...) {
        std::error_code ignored;
        for (std::size_t i = 0; i < pictureCount(film); ++i)
            fs::remove(numbered(start, i + 1), ignored);
        throw;
    }
}

void writeFilm(const PokeFilm& film, const fs::path& file, const Progress& progress) {
    AtomicFile target(file); // before the long work: the user learns at once that it cannot be written
    const QTemporaryDir folder;
    if (!folder.isValid())
        throw FileError(file, "needs room for its pictures in the folder of temporary files");
    const fs::path pictures = fs::path(folder.path().toStdString()) / "film-";
    const fs::path encoded = fs::path(folder.path().toStdString()) / "film.avi";
    ProgressParts parts(progress);
    writePictures(film, pictures, parts.next(1 - encodingShare));
    encodeFilm(pictures, pictureCount(film), encoded, parts.rest());
    const Bytes bytes = readFile(encoded);
    target.write({reinterpret_cast<const char*>(bytes.data()), bytes.size()});
    reportProgress(progress, 1);
    target.commit();
}

} // namespace esm
