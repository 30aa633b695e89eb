 %2052 "Zatim jen nazev
"^^^^^ E0205
"no block yet: the finding stands at the program
