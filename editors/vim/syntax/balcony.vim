" Camera files of Balcony.
if exists("b:current_syntax")
    finish
endif

syntax match balconyStage /\<\h\w*\ze\s*(/
syntax match balconyParameter /\<\h\w*\ze\s*=\_[^=]/
syntax keyword balconyItem import let camera picture layer
syntax match balconyStatement /^\s*\zs\(map\|eye\|toward\|morph\|object\|warp\|move\|look\|for\|arrange\|place\|fit\|fill\|stretch\|show\|hide\|clip\|soft\|alpha\|blend\|frame\|scale_bar\|leader\|stereo\|channels\|lens\|bend\|time\|aspect\|axes\)\>/
syntax match balconyStatement /\<\(above\|from\|to\)\>\ze\s\+[^= ]/
syntax keyword balconyConstant pi t square z_up y_up
syntax keyword balconyFunction abs acos acosh asin asinh atan atan2 atanh cos cosh exp floor
syntax keyword balconyFunction count grey if is_finite keys log max min mod pow select sign sin sinh spow sqrt
syntax keyword balconyFunction tan tanh
syntax match balconyNumber /\<\d\+\(\.\.\@!\d*\)\?\([eE][+-]\?\d\+\)\?\(deg\|rad\)\?\>/
syntax match balconyNumber /\.\@<!\.\d\+\([eE][+-]\?\d\+\)\?\(deg\|rad\)\?\>/
syntax match balconyOperator /\.\.\|==\|!=\|<=\|>=\|&&\|||\|[-+*/^<>!=]/
syntax region balconyText start=/"/ end=/"\|$/
syntax match balconyComment +//.*$+ contains=@Spell
syntax region balconyComment start=+/\*+ end=+\*/+ contains=@Spell

highlight default link balconyItem Structure
highlight default link balconyStatement Keyword
highlight default link balconyStage Function
highlight default link balconyParameter Identifier
highlight default link balconyFunction Function
highlight default link balconyConstant Constant
highlight default link balconyNumber Number
highlight default link balconyOperator Operator
highlight default link balconyText String
highlight default link balconyComment Comment

let b:current_syntax = "balcony"
