# The manual page and the completions of bash, zsh and fish, which the program makes from its table of options, and where
# they are installed.

include(GNUInstallDirs)
set(share_folder ${CMAKE_BINARY_DIR}/share)
file(MAKE_DIRECTORY ${share_folder})
set(share_files "")

# What `crsh ARGUMENTS...` prints becomes share/`file`, installed to `folder` below share/.
function(add_share file folder)
  add_custom_command(OUTPUT ${share_folder}/${file} COMMAND crsh ${ARGN} > ${share_folder}/${file} DEPENDS crsh
                     COMMENT "Printing ${file}" VERBATIM)
  install(FILES ${share_folder}/${file} DESTINATION ${CMAKE_INSTALL_DATADIR}/${folder})
  list(APPEND share_files ${share_folder}/${file})
  set(share_files ${share_files} PARENT_SCOPE)
endfunction()

if(NOT CMAKE_CROSSCOMPILING)
  add_share(crsh.1 man/man1 help --man)
  add_share(crsh bash-completion/completions completion bash)
  add_share(_crsh zsh/site-functions completion zsh)
  add_share(crsh.fish fish/vendor_completions.d completion fish)
  add_custom_target(crsh_share ALL DEPENDS ${share_files})
endif()
