# The medians of out/bench.csv as bars, on a logarithmic axis: gnuplot -e "csv='..'; svg='..'"
set terminal svg size 900, 520 font "sans,12" background "white"
set output svg
set datafile separator ","
set title "Stages of a 512 x 512 frame: median time on one core"
set xlabel "milliseconds (logarithmic)"
set logscale x
set grid xtics
set yrange [:] reverse
set offsets 0, 0, 0.6, 0.6
unset key
set style fill solid 0.6
set lmargin 44
plot csv skip 1 using (0):0:(0.01):2:($0-0.35):($0+0.35):ytic(1) with boxxyerror lc rgb "#3060a0"
