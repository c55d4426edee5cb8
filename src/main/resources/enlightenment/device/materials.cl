// Materials and textures: world.material.SurfaceMaterial, TextureLookup and texture.ImageTexture.

// A material among the integers: what it is, its texture, its image, whether shadows show on it, and where its numbers are: colour, second
// colour of a checkerboard, number of squares, index of refraction, transparency. In physical shading also whether it is black, whether all of
// its lobes are single directions, whether they are narrow where that counts, the sides that glow (1 is the outside, 2 the inside), and whether
// it is glass; its radiance and the numbers of its kind are behind the others.
#define MATERIAL_SIZE 10
#define MATERIAL_KIND 0
#define TEXTURE 1
#define IMAGE 2
#define RECEIVES_SHADOWS 3
#define MATERIAL_NUMBERS 4
#define IS_BLACK 5
#define IS_DELTA 6
#define IS_NARROW 7
#define GLOWING_SIDES 8
#define IS_GLASS 9

#define GLOW 9
#define BSDF_NUMBERS 12

// An image among the integers: width, height, where its texels are (packed, or three floats each), and where the values of bytes are.
#define IMAGE_SIZE 5

__global const int *materialAt(const Scene *s, const Hit *hit) {
    return s->i + s->i[MATERIALS] + MATERIAL_SIZE * s->i[primitive(s, hit->id)[FACES] + hit->face];
}

// texture.ImageTexture
double repeated(double t) {
    if (t >= 0 && t <= 1) {
        return t;
    }
    double fraction = t - floor(t);
    return fraction >= 0 ? fraction : 0;
}

double texel(const Scene *s, __global const int *image, int at, int c) {
    if (image[2] >= 0) {
        return s->d[image[4] + (s->i[image[2] + at] >> (16 - 8 * c) & 255)];
    }
    return s->f[image[3] + 3 * at + c];
}

double mixed4(double v00, double v10, double v01, double v11, double fx, double fy) {
    double above = v00 + fx * (v10 - v00);
    double below = v01 + fx * (v11 - v01);
    return above + fy * (below - above);
}

Vec imageColor(const Scene *s, __global const int *image, bool bilinear, double u, double v, bool wraps) {
    int width = image[0];
    int height = image[1];
    if (!bilinear) {
        int x = min(convert_int_sat_rtz(repeated(u) * width), width - 1);
        int y = min(convert_int_sat_rtz(repeated(v) * height), height - 1);
        int at = y * width + x;
        return vec(texel(s, image, at, 0), texel(s, image, at, 1), texel(s, image, at, 2));
    }
    double x = repeated(u) * width - 0.5;
    double y = repeated(v) * height - 0.5;
    double left = floor(x);
    double top = floor(y);
    double fx = x - left;
    double fy = y - top;
    int x0 = convert_int_sat_rtz(left);
    int x1 = x0 + 1;
    if (x0 < 0) {
        x0 = wraps ? width - 1 : 0;
    }
    if (x1 >= width) {
        x1 = wraps ? 0 : width - 1;
    }
    int row0 = max(convert_int_sat_rtz(top), 0) * width;
    int row1 = min(convert_int_sat_rtz(top) + 1, height - 1) * width;
    double rgb[3];
    for (int c = 0; c < 3; c++) {
        rgb[c] = mixed4(texel(s, image, row0 + x0, c), texel(s, image, row0 + x1, c), texel(s, image, row1 + x0, c),
                texel(s, image, row1 + x1, c), fx, fy);
    }
    return vec(rgb[0], rgb[1], rgb[2]);
}

bool isOddSquare(double coordinate, double checks) {
    double square = floor(coordinate * checks);
    if (coordinate <= 1) {
        square = smaller(square, ceil(checks) - 1);
    }
    return (convert_long_sat_rtz(square) & 1) != 0;
}

Vec colorAt(Scene *s, const Hit *hit, __global const int *material) {
    __global const double *q = s->d + material[MATERIAL_NUMBERS];
    int texture = material[TEXTURE];
    if (texture == SOLID) {
        return vecAt(q);
    }
    double uv[2];
    placeOnTexture(s, hit, uv);
    if (texture == CHECKER) {
        return vecAt(isOddSquare(uv[0], q[6]) != isOddSquare(uv[1], q[6]) ? q + 3 : q);
    }
    s->textureLookups++;
    __global const int *image = s->i + s->i[IMAGES] + IMAGE_SIZE * material[IMAGE];
    return imageColor(s, image, texture == BILINEAR, uv[0], uv[1], repeats(s, hit->id));
}
