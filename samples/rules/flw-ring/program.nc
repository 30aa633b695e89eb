%105 "FLW-2 skippable calls and calls never reached count too
N10 G90 G0 X0 Y0
N20 G72 L9091
N30 G73 L50
N40 G72 L9093
N50 M30
