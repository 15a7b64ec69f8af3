; Comments
G0 X1 (a comment) Y2 (nested (comment) here) Z3
G0 X1 (not closed Y2
G0 X1 (not ( closed ) Y2
(only a comment)
; only a comment
#MSG ["( ; no comment )"] ; a comment (
G0 X1 ) Y2 ; error 20797 ")"
; --- comment blocks
#COMMENT BEGIN
$IF :: anything ( goes "
#COMMENT BEGIN
#COMMENT END
G0 X1
N10 #COMMENT BEGIN
:: ( not closed #COMMENT
N20 #COMMENT END
G0 X2
; --- comment blocks that are not alone
G0 X1 #COMMENT BEGIN ; error 20566 "#COMMENT BEGIN"
text
#COMMENT END G0 X2 ; error 20569 "#COMMENT END"
G0 X3 ::: ; error 20797 ":"
#COMMENT BEGIN text ; error 20566 "#COMMENT BEGIN"
text #COMMENT END ; error 20569 "#COMMENT END"
; --- a comment block that never ends
G0 X1
#COMMENT BEGIN ; error 20568 "never closed"
text
; --- continued blocks
G1 X1 \
  Y2 \
  ; a comment in between \

  N30 Z3
G1 X1 \
  Y:2 ; error 20797 ":"
G1 X1 (comment) \
  Z3
P1 = [1 + \
  2] * \
  3
; --- a backslash elsewhere
G0 X1 \ Y2 ; error 20797 "\"
; --- an expression too deep
P1 = [[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[1]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]
P1 = [[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[1]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]] ; error 20386 "64"
; --- signs that do not print
G0 X1 ∅ ; error 20797 "∅"
äöü ß
