" Camera files of Balcony.
if exists("b:did_ftplugin")
    finish
endif
let b:did_ftplugin = 1

setlocal commentstring=//\ %s comments=:// expandtab shiftwidth=4 textwidth=100
if executable("balcony")
    setlocal formatprg=balcony\ fmt\ -
endif
let b:undo_ftplugin = "setlocal commentstring< comments< expandtab< shiftwidth< textwidth< formatprg<"
