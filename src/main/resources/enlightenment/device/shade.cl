// Shades samples of a tile, pixel by pixel in rows: work item i is the sample begin + i. first[k] is the number of the first sample of the
// tile's pixel k, start[k] its index among all of the tile. The file before says what a Path is, how it begins and how it is followed.
__kernel void shade(__global const double *doubles, __global const int *ints, __global const float *floats, ulong seed, int left, int top,
        int width, int pixels, int begin, int end, __global const int *first, __global const int *start, __global double *rgb,
        __global int *states, __global int *counts) {
    int place = (int) get_global_id(0);
    int item = begin + place;
    if (item >= end) {
        return;
    }
    Scene s;
    beginScene(&s, doubles, ints, floats);
    int pixel = pixelOf(start, pixels, item);
    Path path;
    path.sampler = samplerOf(seed, left + pixel % width, top + pixel / width, (uint) (first[pixel] + item - start[pixel]));
    path.surfaces = 0;
    path.bounces = 0;
    path.straight = 0;
    path.solids.count = 0;
    path.throughput = vec(1, 1, 1);
    path.light = vec(0, 0, 0);
    beginPath(&path);
    setCameraRay(&s, &path.ray, &path.sampler);
    while (s.state == DONE && follow(&s, &path)) {
    }
    finish(&s, path.light, place, rgb, states, counts);
}
