# stage: percentage
# what: shadow/window, share_of_dark: 255 count / k^2, rounded once
# unit: level of 255
# bound: 0.5
@half_up = fixed<0,nu>;
out = half_up(255 * count / taps);
# weaken: [0, 0.5] => [0, 0.49]
{ |out - 255 * count / taps| in [0, 0.5] }
