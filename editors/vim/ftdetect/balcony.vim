autocmd BufRead,BufNewFile *.cam setfiletype balcony
