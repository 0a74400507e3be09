#pragma once

#include "tests/support/temporary_folder.h"

#include <QSettings>

/// The user's own settings and files are neither read nor written while this lives. To be made before the
/// application.
class ScratchSettings {
public:
    ScratchSettings() {
        qputenv("XDG_DATA_HOME", QByteArray::fromStdString((m_folder / "data").string()));
        QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope,
                           QString::fromStdString(m_folder.path().string()));
    }

    /// Where files that are of no use later may lie too.
    const std::filesystem::path& folder() const { return m_folder.path(); }

private:
    TemporaryFolder m_folder;
};
