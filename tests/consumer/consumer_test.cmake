# Installs the core, builds strangers' programs against it and lets them load a model package.
#   cmake -D BUILD=… -D SOURCE=… -D ESMC=… -P consumer_test.cmake
set(work ${BUILD}/consumer)
file(REMOVE_RECURSE ${work})

function(run)
  execute_process(COMMAND ${ARGV} COMMAND_ERROR_IS_FATAL ANY OUTPUT_VARIABLE output)
  set(output ${output} PARENT_SCOPE)
endfunction()

function(build_consumer source)
  run(${CMAKE_COMMAND} -S ${source} -B ${work}/build/${source} -G Ninja -DCMAKE_PREFIX_PATH=${work}/installed
      -DCMAKE_RUNTIME_OUTPUT_DIRECTORY=${work}/bin)
  run(${CMAKE_COMMAND} --build ${work}/build/${source})
endfunction()

function(expect_output text)
  run(${ARGN})
  if(NOT output MATCHES "${text}")
    message(FATAL_ERROR "the consumer printed: ${output}")
  endif()
endfunction()

run(${CMAKE_COMMAND} --install ${BUILD} --prefix ${work}/installed)
run(${ESMC} sample tube -o ${work}/tube.esm)
run(${ESMC} texture pack ${work}/tube.esm --size 64 -o ${work}/tube.esm)
run(${ESMC} export ${work}/tube.esm --to glb -o ${work}/tube.glb)
build_consumer(${SOURCE})
build_consumer(${SOURCE}/mechanics)
build_consumer(${SOURCE}/c)
expect_output("170 nodes, 1 picture of 64 pixels" ${work}/bin/consumer ${work}/tube.glb)
expect_output("170 nodes, 320 triangles" ${work}/bin/mechanics_consumer ${work}/tube.glb)
expect_output("170 nodes, 340 springs, split" ${work}/bin/c_consumer ${work}/tube.glb)
