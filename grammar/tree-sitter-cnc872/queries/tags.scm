; The entry of a subprogram or macrocycle; its words may stand in either order.
((block
  (preparatory_function value: (number) @_function)
  (target_word value: (number) @name)) @definition.function
  (#match? @_function "^0*79$"))

((block
  (target_word value: (number) @name)
  (preparatory_function value: (number) @_function)) @definition.function
  (#match? @_function "^0*79$"))

; Calls of subprograms and macrocycles.
((block
  (preparatory_function value: (number) @_function)
  (target_word value: (number) @name) @reference.call)
  (#match? @_function "^0*(71|72)$"))

((block
  (target_word value: (number) @name) @reference.call
  (preparatory_function value: (number) @_function))
  (#match? @_function "^0*(71|72)$"))
