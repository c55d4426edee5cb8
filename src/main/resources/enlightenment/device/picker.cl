// One of many lights: emitter.LightSampler, LightWeights, LightTree and SampledLight. Among the integers: for each light in the sampler's
// order what it is (LightWeights' kinds) and its index; then the places of lights by their indices; with a tree, then for each node the second
// child (or −1 − its light), for each node its parent, and for each light its leaf.
#define FEW_LIGHTS 16
#define WEIGHED_BALL 0
#define WEIGHED_FLAT 1
#define WEIGHED_TWO_SIDED 2
#define WEIGHT_SIZE 8
#define TREE_NODE 10
#define LEAST_SQUARE 0x1p-900
#define MOST_REST 0x1.fffffffffffffp-1
#define TREE_CUT 6
#define TREE_SLACK GAMMA(64)

typedef struct {
    double weights[FEW_LIGHTS];
    int nodes[FEW_LIGHTS];
    int count;
    int light;
    double probability;
    double rest;
} Choice;

double weightOfBall(double square, double height, double radius, bool everywhere) {
    double distance = sqrt(square);
    if (!(distance > radius)) {
        return 0;
    }
    double s = radius / distance;
    if (everywhere) {
        return PI * s * s;
    }
    double k = height / distance;
    if (k >= s) {
        return PI * k * s * s;
    }
    return k <= -s ? 0 : cutSphere(s, sqrt((distance - radius) * (distance + radius)) / distance, k);
}

double meanCosineOverBall(double height, double radius, double distance) {
    if (height >= radius) {
        return distance > 0 ? height / distance : 0;
    }
    double reach = height + radius;
    return reach > 0 ? smaller(reach * reach / (4 * radius * distance), 1) : 0;
}

double roughWeight(__global const double *q, int kind, double dx, double dy, double dz, double square, double height, bool everywhere) {
    double radius = q[3];
    double strength = q[7];
    double distance = sqrt(square);
    if (kind == WEIGHED_FLAT || kind == WEIGHED_TWO_SIDED) {
        double side = -(q[4] * dx + q[5] * dy + q[6] * dz);
        side = kind == WEIGHED_FLAT ? side : fabs(side);
        if (!(side > 0)) {
            return 0;
        }
        strength *= side / larger(side, distance - radius);
    }
    double cosine = everywhere ? 1 : meanCosineOverBall(height, radius, distance);
    return strength * cosine / larger(larger(square, radius * radius), LEAST_SQUARE);
}

double weightOf(const Scene *s, int place, Vec p, Vec n) {
    __global const double *q = s->d + s->i[PICKER_WEIGHTS] + WEIGHT_SIZE * place;
    __global const int *which = s->i + s->i[PICKER] + 2 * place;
    double dx = q[0] - p.x;
    double dy = q[1] - p.y;
    double dz = q[2] - p.z;
    double square = dx * dx + dy * dy + dz * dz;
    double height = n.x * dx + n.y * dy + n.z * dz;
    bool everywhere = n.x == 0 && n.y == 0 && n.z == 0;
    double radius = q[3];
    int kind = which[0];
    if (kind == WEIGHED_BALL) {
        return q[7] * weightOfBall(square, height, radius, everywhere);
    }
    double rough = roughWeight(q, kind, dx, dy, dz, square, height, everywhere);
    if (rough > 0 && !everywhere && lightOf(s, which[1])[LIGHT_KIND] == RECTANGLE_LIGHT && square < 4.0 * 4.0 * radius * radius) {
        Seen near;
        lookAt(s, &near, which[1], p);
        return q[7] / near.view.q[LIGHT_AREA] * irradianceOf(&near, n) + 0x1p-10 * rough;
    }
    return rough;
}

// A bound of a cosine from 0 on, and above 0 where rounding leaves it in doubt.
double positiveCosine(double cosine) {
    return cosine > -TREE_SLACK ? larger(cosine, TREE_SLACK) : 0;
}

double atMost(double cosine, double ballCosine, double ballSine) {
    if (cosine >= ballCosine) {
        return 1;
    }
    double sine = sqrt(larger((1 - cosine) * (1 + cosine), 0));
    return positiveCosine(cosine * ballCosine + sine * ballSine);
}

double emittedWithin(double cosine, double cosO, double sinO, double ballCosine, double ballSine) {
    if (cosine >= cosO) {
        return 1;
    }
    double sine = sqrt(larger((1 - cosine) * (1 + cosine), 0));
    double less = cosine * cosO + sine * sinO;
    if (less >= ballCosine) {
        return 1;
    }
    double lessSine = larger(sine * cosO - cosine * sinO, 0);
    return positiveCosine(less * ballCosine + lessSine * ballSine);
}

__global const int *secondChildren(const Scene *s) {
    return s->i + s->i[PICKER] + 3 * s->i[LIGHT_COUNT];
}

double importanceOf(const Scene *s, int node, Vec p, Vec n) {
    int second = secondChildren(s)[node];
    if (second < 0) {
        return weightOf(s, -1 - second, p, n);
    }
    __global const double *q = s->d + s->i[PICKER_TREE] + TREE_NODE * node;
    double dx = q[0] - p.x;
    double dy = q[1] - p.y;
    double dz = q[2] - p.z;
    double radius = q[3];
    double square = dx * dx + dy * dy + dz * dz;
    double strength = q[9] / larger(larger(square, radius * radius), LEAST_SQUARE);
    if (square <= radius * radius) {
        return strength;
    }
    double inverse = 1 / sqrt(square);
    double sine = radius * inverse;
    double cosine = sqrt(larger((1 - sine) * (1 + sine), 0));
    if (n.x != 0 || n.y != 0 || n.z != 0) {
        strength *= atMost((n.x * dx + n.y * dy + n.z * dz) * inverse, cosine, sine);
    }
    double spread = q[7];
    if (spread > -1) {
        double towards = -(q[4] * dx + q[5] * dy + q[6] * dz) * inverse;
        strength *= emittedWithin(towards, spread, q[8], cosine, sine);
    }
    return strength;
}

// Splits the most important node until there are enough; returns the sum of importances.
double cutTree(const Scene *s, Vec p, Vec n, Choice *c) {
    __global const int *second = secondChildren(s);
    c->nodes[0] = 0;
    c->weights[0] = 1;
    c->count = 1;
    while (c->count < TREE_CUT) {
        int most = -1;
        double largest = 0;
        for (int i = 0; i < c->count; i++) {
            if (c->weights[i] > largest && second[c->nodes[i]] >= 0) {
                largest = c->weights[i];
                most = i;
            }
        }
        if (most < 0) {
            break;
        }
        int node = c->nodes[most];
        double a = importanceOf(s, node + 1, p, n);
        double b = importanceOf(s, second[node], p, n);
        c->nodes[most] = node + 1;
        c->weights[most] = a;
        c->nodes[c->count] = second[node];
        c->weights[c->count++] = b;
    }
    double sum = 0;
    for (int i = 0; i < c->count; i++) {
        sum += c->weights[i];
    }
    return sum;
}

double weighAll(const Scene *s, Vec p, Vec n, Choice *c) {
    double sum = 0;
    c->count = s->i[LIGHT_COUNT];
    for (int i = 0; i < c->count; i++) {
        c->weights[i] = weightOf(s, i, p, n);
        sum += c->weights[i];
    }
    return sum;
}

// One of the weights, of which this is the sum; -1 if all are 0.
int pickWeight(Choice *c, double sum, double number) {
    c->light = -1;
    c->probability = 0;
    if (!(sum > 0)) {
        return -1;
    }
    double left = number * sum;
    int chosen = -1;
    for (int i = 0; i < c->count; i++) {
        double w = c->weights[i];
        if (w > 0) {
            chosen = i;
            if (left < w) {
                break;
            }
            left -= w;
        }
    }
    c->probability = c->weights[chosen] / sum;
    c->rest = smaller(left / c->weights[chosen], MOST_REST);
    return chosen;
}

// The place of the light that a number chooses in the tree; -1 if there is none.
int descendTree(const Scene *s, Vec p, Vec n, Choice *c, int chosen) {
    __global const int *second = secondChildren(s);
    int node = c->nodes[chosen];
    while (second[node] >= 0) {
        double a = importanceOf(s, node + 1, p, n);
        double b = importanceOf(s, second[node], p, n);
        double sum = a + b;
        if (!(sum > 0)) {
            return -1;
        }
        double share = a / sum;
        double rest = c->rest;
        bool first = b == 0 || rest < share;
        double part = first ? share : b / sum;
        rest = smaller(first ? rest / share : (rest - share) / part, MOST_REST);
        c->rest = larger(rest, 0);
        c->probability *= part;
        node = first ? node + 1 : second[node];
    }
    return -1 - second[node];
}

// Whether there is a light that may contribute.
bool chooseLight(const Scene *s, Vec p, Vec n, double number, Choice *c) {
    bool hasTree = s->i[LIGHT_COUNT] > FEW_LIGHTS;
    double sum = hasTree ? cutTree(s, p, n, c) : weighAll(s, p, n, c);
    int place = pickWeight(c, sum, number);
    if (place >= 0 && hasTree) {
        place = descendTree(s, p, n, c, place);
    }
    if (place < 0) {
        return false;
    }
    c->light = s->i[s->i[PICKER] + 2 * place + 1];
    return true;
}

double probabilityInTree(const Scene *s, int place, Vec p, Vec n, Choice *c) {
    __global const int *second = secondChildren(s);
    int nodes = 2 * s->i[LIGHT_COUNT] - 1;
    __global const int *parents = second + nodes;
    double all = cutTree(s, p, n, c);
    double probability = 1;
    int node = parents[nodes + place];
    while (true) {
        for (int i = 0; i < c->count; i++) {
            if (c->nodes[i] == node) {
                return all > 0 ? probability * (c->weights[i] / all) : 0;
            }
        }
        int parent = parents[node];
        double own = importanceOf(s, node, p, n);
        if (!(own > 0)) {
            return 0;
        }
        int sibling = node == parent + 1 ? second[parent] : parent + 1;
        probability *= own / (own + importanceOf(s, sibling, p, n));
        node = parent;
    }
}

double probabilityOfLight(const Scene *s, int light, Vec p, Vec n, Choice *c) {
    int place = s->i[s->i[PICKER] + 2 * s->i[LIGHT_COUNT] + light];
    if (s->i[LIGHT_COUNT] > FEW_LIGHTS) {
        return probabilityInTree(s, place, p, n, c);
    }
    double sum = weighAll(s, p, n, c);
    return sum > 0 ? c->weights[place] / sum : 0;
}
