(block) @function.around
(block (word) @function.inside)
(word value: (_) @parameter.inside) @parameter.around
(comment) @comment.inside
(comment)+ @comment.around
