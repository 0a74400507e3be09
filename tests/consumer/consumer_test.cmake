# Installs the core, builds a stranger's program against it and lets that load a model package.
#   cmake -D BUILD=… -D SOURCE=… -D ESMC=… -P consumer_test.cmake
set(work ${BUILD}/consumer)
file(REMOVE_RECURSE ${work})
foreach(command
    "${CMAKE_COMMAND};--install;${BUILD};--prefix;${work}/installed"
    "${CMAKE_COMMAND};-S;${SOURCE};-B;${work}/build;-G;Ninja;-DCMAKE_PREFIX_PATH=${work}/installed"
    "${CMAKE_COMMAND};--build;${work}/build"
    "${ESMC};sample;tube;-o;${work}/tube.esm"
    "${ESMC};texture;pack;${work}/tube.esm;--size;64;-o;${work}/tube.esm"
    "${ESMC};export;${work}/tube.esm;--to;glb;-o;${work}/tube.glb"
    "${work}/build/consumer;${work}/tube.glb")
  execute_process(COMMAND ${command} COMMAND_ERROR_IS_FATAL ANY OUTPUT_VARIABLE output)
endforeach()
if(NOT output MATCHES "170 nodes, 1 picture of 64 pixels")
  message(FATAL_ERROR "the consumer printed: ${output}")
endif()
