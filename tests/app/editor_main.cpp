#include "app/editor/window/application.h"
#include "tests/support/scratch_settings.h"

#include <gtest/gtest.h>

int main(int argc, char** argv) {
    testing::InitGoogleTest(&argc, argv);
    const ScratchSettings settings;
    esm::Application application(argc, argv);
    QCoreApplication::setOrganizationName(QStringLiteral("esm"));
    QCoreApplication::setApplicationName(QStringLiteral("esm-tests"));
    return RUN_ALL_TESTS();
}
