package starlogo.geometry
{
    /**
     * How near two shapes of a game have to be to touch. This is the one rule of all tests that say whether or when two touch: of shapes that
     * stand, that move and that are asked about; of structures, hierarchies, triangles and the ground.
     *
     * <p>Two shapes touch if the distance of their cores is at most the sum of these lengths. A core is a sphere's centre, a capsule's axis, a whole
     * box, triangle or hull.</p>
     *
     * <ul>
     * <li>the two radii, times Tolerances.TOUCHING. For two boxes and for hulls, half-extents count as radii</li>
     * <li>for each of the two, the margin of its place (<code>marginOfPlace()</code>)</li>
     * <li>for each of the two that is a model's triangle, the margin of its surface (<code>marginOfSurface()</code>). A node's box already includes it</li>
     * <li>while one of the two moves, the margins of its motion's two vectors (<code>marginOfMotion()</code>)</li>
     * <li>a ray is a shape without a radius. At a sphere and a capsule the radius counts, at a box and a hull the half-extents or the distances of the
     *     faces from the centre, times Tolerances.TOUCHING; at triangles the margin of the surface. The place of a hit at a box, a hull or a triangle
     *     includes no tolerance</li>
     * <li>where the package convex decides, Tolerances.CORES of the bounding radii of both cores</li>
     * </ul>
     *
     * <p>These lengths decide whether two shapes touch at all. The other answers leave them out: they are the time at which the distance of the cores is
     * the sum of the radii, the distance, and the depth. There are four exceptions. They are as small as rounding.</p>
     *
     * <ul>
     * <li>A structure of a game is placed in the world once for all questions (<code>Body.worldStructure()</code>). It is widened there by the margin
     *     of its place, so all its answers include that margin</li>
     * <li>Where nodes of a tree decide about a structure, or give a distance, one of the two is widened by the margins of
     *     both places. So times and distances include these</li>
     * <li>The times of two agents that are spheres (SpherePairTests) and of an agent and an edge of the world (EdgePairTests) include all that decides,
     *     because one closed form gives both</li>
     * <li>SpherePairTests counts one vector of the motion: the other one is 0 or its reverse. EdgePairTests counts Tolerances.ROUNDING of the extent
     *     in place of the motion. Where the nodes of two trees decide, ImpactTraversal counts the vector from one model to the other at the start in
     *     place of the vector to the start</li>
     * </ul>
     *
     * <p>The package intersection compares structures that have no place in a game, so there the margins of places and surfaces are 0. Its
     * functions for two spheres are stricter: they leave out Tolerances.TOUCHING too, because they compute no intermediate points that could be
     * rounded. The tests of a game pass them radii that include all of it.</p>
     *
     * @private
     */
    public final class Touching
    {
        /** The margin that rounding a place causes. */
        public static function marginOfPlace(x:Number, y:Number, z:Number):Number
        {
            return Tolerances.PLACES * (Math.abs(x) + Math.abs(y) + Math.abs(z));
        }

        /**
         * The margin that rounding a surface causes.
         *
         * @param radius of a sphere around the model
         */
        public static function marginOfSurface(radius:Number):Number
        {
            return Tolerances.SURFACES * radius;
        }

        /**
         * The margin that rounding a vector of a motion causes. A motion has two such vectors: the one to its start, and the one from there
         * to its end.
         */
        public static function marginOfMotion(x:Number, y:Number, z:Number):Number
        {
            // Math.abs would be a call for each number.
            var sum:Number = x < 0 ? -x : x;
            sum = y < 0 ? sum - y : sum + y;
            sum = z < 0 ? sum - z : sum + z;
            return Tolerances.ROUNDING * sum;
        }
    }
}
