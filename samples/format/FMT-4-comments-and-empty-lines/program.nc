%1


   "own line   
 	
N10 G00 "open 	



N20 M30