#include "app/editor/window/application.h"
#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>

#include <QSettings>
#include <QStandardPaths>

int main(int argc, char** argv) {
    testing::InitGoogleTest(&argc, argv);
    // The user's own settings and files are neither read nor written.
    QStandardPaths::setTestModeEnabled(true);
    const TemporaryFolder settings;
    QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope,
                       QString::fromStdString(settings.path().string()));
    esm::Application application(argc, argv);
    QCoreApplication::setOrganizationName(QStringLiteral("esm"));
    QCoreApplication::setApplicationName(QStringLiteral("esm-tests"));
    return RUN_ALL_TESTS();
}
