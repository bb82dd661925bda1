// Whether a number is prime, by trial division up to its root.
kernel void prime_sieve(global uchar* is_prime) {
  const uint n = (uint)get_global_id(0) + 2;
  uchar prime = 1;
  for (uint d = 2; d * d <= n; ++d)
    if (n % d == 0) {
      prime = 0;
      break;
    }
  is_prime[get_global_id(0)] = prime;
}
