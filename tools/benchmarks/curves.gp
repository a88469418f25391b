# The cost curves of out/curves.csv on logarithmic axes: gnuplot -e "csv='..'; svg='..'"
set terminal svg size 900, 620 font "sans,12" background "white"
set output svg
set datafile separator ","
set title "Time of a frame on one core, and what it grows with"
set xlabel "number (pixels, facets, surfaces, lights)"
set ylabel "milliseconds"
set logscale xy
set grid
set key outside right
join(n) = system(sprintf("echo '%s' | tr '_' ' '", n))
names = system(sprintf("tail -n +2 '%s' | cut -d, -f1 | uniq | tr ' ' '_'", csv))
plot for [n in names] csv skip 1 \
     using (strcol(1) eq join(n) ? $2 : NaN):3 with linespoints title join(n)
