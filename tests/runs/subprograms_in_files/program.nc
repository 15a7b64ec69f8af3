; calls of files: in the own folder, below it, by a computed name, with values
L first.sub
L CYCLE [NAME=parts\Second.sub @P1=2.5 @P3="text"]
L "parts/third.sub"
LL AGAIN
M30
%L AGAIN
L first.sub
M17
