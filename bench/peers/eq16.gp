\\ FJ07.16 against FJ07.13 in PARI/GP, n = 3, every knot, L* and M* a variable, at every vertex.
\\ L=10 VARIANT=forms gp -q -f -s 2G eq16.gp   prints the milliseconds of processor time of one proof. VARIANT is
\\   field   the control points are variables too
\\   forms   a point is the vector of its coefficients: linear forms in the control points
n = 3;
L = eval(getenv("L"));
variant = getenv("VARIANT");
name(s, i) = eval(Str(s, i));
prove(last, points) =
{
  my(u = vector(last + n, i, name("u", i - 1)), l = 'l, m = 'm, c = points[1 .. last + 1], d = points[last + 2], row = d, total, p);
  for (vertex = 1, last,
    my(high = u[vertex + n], low = u[vertex]);
    row = ((high - l) * c[vertex] + (l - low) * c[vertex + 1] - (high - m) * row) / (m - low);
    total = 0 * d; p = 1;
    forstep (i = vertex, 1, -1,
      total += (c[i + 1] - c[i]) * (p / (m - u[i]));
      p *= (m - u[i + n]) / (m - u[i]));
    if (row - c[vertex + 1] - (d - c[1]) * p - (l - m) * total != 0 * d, error("not proved at ", vertex)));
}
points = if (variant == "forms", my(e = matid(L + 2)); vector(L + 2, i, e[, i]), vector(L + 2, i, name("c", i - 1)));
gettime();
prove(L, points);
print(gettime());
quit
