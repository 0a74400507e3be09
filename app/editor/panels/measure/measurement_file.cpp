#include "app/editor/panels/measure/measurement_file.h"

#include "app/editor/dialogs/ask.h"
#include "app/editor/dialogs/attempt.h"
#include "app/editor/document/file_memory.h"
#include "core/exchange/charts/chart_file.h"
#include "core/support/file_io.h"

namespace esm {

QString writeMeasurement(QWidget* window, const NewFile& asked, const QString& failure,
                         const std::function<void(const std::filesystem::path&)>& writing) {
    const auto file = ask(*window, [&] { return chooseNewFile(window, asked); });
    if (!file || !attempt(window, failure, [&] { writing(*file); })) return {};
    rememberFolder(FileKind::Package, *file);
    return QObject::tr("%1 is written").arg(QString::fromStdString(file->filename().string()));
}

QString saveTable(QWidget* window, const Document& document, const std::function<std::string()>& table) {
    return writeMeasurement(window,
                            fileForOthers(document, QObject::tr("Save table"), QObject::tr("Tables (*.csv)"),
                                          {QStringLiteral(".csv")}),
                            QObject::tr("The table was not written"),
                            [&](const std::filesystem::path& file) { writeFileAtomically(file, table()); });
}

QString saveChart(QWidget* window, const Document& document, const std::function<Drawing()>& chart) {
    return writeMeasurement(window,
                            fileForOthers(document, QObject::tr("Save chart"),
                                          QObject::tr("Pictures (*.png);;Drawings (*.svg)"),
                                          {QStringLiteral(".png"), QStringLiteral(".svg")}),
                            QObject::tr("The chart was not written"),
                            [&](const std::filesystem::path& file) { writeChart(chart(), file); });
}

} // namespace esm
