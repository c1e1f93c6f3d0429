package starlogo.geometry
{
    /**
     * The rounding error of a product, exact (Dekker, "A floating-point technique for extending the available precision", 1971): the product
     * plus it is a times b.
     *
     * @param a up to 1e290 in magnitude, because the largest Numbers cannot be split
     * @param b as a
     * @param product the product of the two, rounded
     * @private
     */
    public function roundingOfProduct(a:Number, b:Number, product:Number):Number
    {
        // 2^27 + 1 splits a Number into two halves whose products are exact
        var highA:Number = 134217729 * a;
        highA -= highA - a;
        var lowA:Number = a - highA;
        var highB:Number = 134217729 * b;
        highB -= highB - b;
        var lowB:Number = b - highB;
        return highA * highB - product + highA * lowB + lowA * highB + lowA * lowB;
    }
}
