// Structures by value: nested, with padding, with arrays and vectors; program-scope constants.
typedef struct {
  char tag;
  short4 corner;
  double weights[2];
} Part;
typedef struct {
  uchar kind;
  Part parts[2];
  union {
    int whole;
    float real;
  } number;
  ulong last;
} Plan;
typedef struct __attribute__((packed)) {
  char c;
  int i;
} Packed;

constant int primes[] = {2, 3, 5, 7, 11, 13};
constant float2 pair = (float2)(0.5f, -4.0f);
constant char text[] = "warp";
constant Plan fixed_plan = {9,
                            {{1, (short4)(2, 3, 4, 0), {0.25, 0.5}}, {-5, (short4)(6, 7, -8, 0), {1.5, 2.5}}},
                            {77},
                            1ul << 40};

double weigh(const Plan plan, int i) {
  return plan.parts[i & 1].weights[i >> 1 & 1] * plan.kind + plan.parts[i & 1].corner.z;
}

Part turned(Part part, int by) {
  part.tag += by;
  part.corner = part.corner.yzxw;
  return part;
}

kernel void structs(global double* a, global long* b, Plan plan, Packed packed, global Packed* all) {
  const int i = get_global_id(0);
  Plan mine = i & 2 ? fixed_plan : plan;
  mine.parts[0] = turned(mine.parts[1], i);
  a[i] = weigh(mine, i) + pair.y * pair.x;
  b[i] = mine.last + mine.number.whole + mine.parts[0].tag + mine.parts[0].corner.x + primes[i] + text[i & 3] +
         sizeof(Plan) + sizeof(Packed);
  all[i].i = packed.i * i;
  all[i].c = packed.c;
}
