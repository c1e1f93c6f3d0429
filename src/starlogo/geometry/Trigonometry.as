package starlogo.geometry
{
    /**
     * Sine, cosine and arctangent in degrees. The results are the same in every player, to the last bit. The language's own functions do
     * not promise this. Quarter turns are exact. Errors are less than 0.8 units in the last place for sine and cosine, and 0.51 for the
     * arctangent.
     *
     * <p>Angles are first reduced to -45 to 45 degrees, which is exact. Then they are converted to radians as the sum of two Numbers: the
     * product with a constant, and its rounding error (Dekker, "A floating-point technique for extending the available precision", 1971).
     * Taylor's series compute the result.</p>
     */
    public final class Trigonometry
    {
        // Pi / 180: rounded, and the rounding error. 180 / pi: the same.
        private static const RADIANS:Number = 0.017453292519943295;
        private static const RADIANS_REST:Number = 2.9486522708701687e-19;
        private static const DEGREES:Number = 57.29577951308232;
        private static const DEGREES_REST:Number = -1.9878495670576283e-15;

        // The arctangents of 0 to 16 sixteenths: rounded, and the rounding errors.
        private static const ARCTANGENTS:Vector.<Number> = new <Number>[0, 3.576334374997351, 7.125016348901798, 10.619655276155134,
                14.036243467926479, 17.35402463626132, 20.556045219583464, 23.629377730656817, 26.56505117707799,
                29.357753542791272, 32.005383208083494, 34.5085229876684, 36.86989764584402, 39.0938588862295,
                41.18592516570965, 43.1523897340054, 45];
        private static const RESTS:Vector.<Number> = new <Number>[0, -4.254839715196495e-17, -1.2948639595014213e-16, 3.9353821206767933e-16,
                -1.178545638282857e-16, 2.629325578208967e-16, 7.735753643362621e-16, -3.857270537916843e-17, -6.673432494950659e-16,
                3.183231713449758e-16, 1.8761647814886433e-15, 1.6654005518742188e-15, 1.3346864989901319e-15, 2.335881743638655e-15,
                -2.0942594695766676e-15, 8.502900827062482e-16, 0];

        /**
         * The sine of an angle in degrees.
         *
         * @param angle in degrees
         * @return NaN for an angle that is not finite
         */
        public static function sine(angle:Number):Number
        {
            return sineOfSum(angle, 0);
        }

        /**
         * The cosine of an angle in degrees.
         *
         * @param angle in degrees
         * @return NaN for an angle that is not finite
         */
        public static function cosine(angle:Number):Number
        {
            return sineOfSum(angle, 1);
        }

        /**
         * The angle from the x axis to a point, in degrees, from -180 to 180.
         *
         * @param y of the point, of a magnitude up to 1e280. If both are below 1e-280, the angle loses digits
         * @param x of the point, as y
         * @return 0 for the origin
         */
        public static function arctangent(y:Number, x:Number):Number
        {
            var smaller:Number = y < 0 ? -y : y;
            var larger:Number = x < 0 ? -x : x;
            var isSteep:Boolean = smaller > larger;
            if (isSteep)
            {
                var swapped:Number = smaller;
                smaller = larger;
                larger = swapped;
            }
            if (larger == 0)
            {
                return 0;
            }
            // Start from the nearest known angle: tan (a - b) = (tan a - tan b) / (1 + tan a tan b).
            var nearest:int = smaller / larger * 16 + 0.5;
            var product:Number = nearest * larger;
            var across:Number = 16 * smaller - product;
            var acrossRest:Number = -roundingOfProduct(nearest, larger, product);
            product = nearest * smaller;
            var along:Number = 16 * larger + product;
            var alongRest:Number = roundingOfProduct(nearest, smaller, product) + (16 * larger - along + product);
            var tangent:Number = across / along;
            product = tangent * along;
            var tangentRest:Number = (across - product - roundingOfProduct(tangent, along, product) + acrossRest - tangent * alongRest) / along;
            var squared:Number = tangent * tangent;
            // The series: 1/3, 1/5, ... 1/11.
            tangentRest += tangent * squared * (-0.3333333333333333 + squared * (0.2 + squared * (-0.14285714285714285
                            + squared * (0.1111111111111111 - squared * 0.09090909090909091))));
            var turned:Number = tangent * DEGREES;
            var rest:Number = roundingOfProduct(tangent, DEGREES, turned) + tangent * DEGREES_REST + tangentRest * DEGREES + RESTS[nearest];
            var angle:Number = ARCTANGENTS[nearest] + turned;
            if (nearest > 0)
            {
                rest += ARCTANGENTS[nearest] - angle + turned;
            }
            if (isSteep)
            {
                turned = angle;
                angle = 90 - turned;
                rest = 90 - angle - turned - rest;
            }
            if (x < 0)
            {
                turned = angle;
                angle = 180 - turned;
                rest = 180 - angle - turned - rest;
            }
            angle += rest;
            return y < 0 ? -angle : angle;
        }

        // The sine of an angle plus some quarter turns.
        private static function sineOfSum(angle:Number, quarters:int):Number
        {
            if (angle >= 360 || angle <= -360)
            {
                angle %= 360;
            }
            var turns:Number = angle * 0.011111111111111112;
            var nearest:int = turns < 0 ? turns - 0.5 : turns + 0.5;
            angle -= 90 * nearest;
            switch (nearest + quarters & 3)
            {
                case 0:
                    // The sum is never -0.
                    return 0 + sineOfSmall(angle);
                case 1:
                    return cosineOfSmall(angle);
                case 2:
                    return 0 - sineOfSmall(angle);
                default:
                    return 0 - cosineOfSmall(angle);
            }
        }

        // The sine of -45 to 45 degrees. The series: 1/3!, 1/5!, ... 1/17!.
        private static function sineOfSmall(angle:Number):Number
        {
            var x:Number = angle * RADIANS;
            var squared:Number = x * x;
            var rest:Number = squared * (-0.16666666666666666 + squared * (0.008333333333333333 + squared * (-0.0001984126984126984
                            + squared * (2.7557319223985893e-6 + squared * (-2.505210838544172e-8 + squared * (1.6059043836821613e-10
                                        + squared * (-7.647163731819816e-13 + squared * 2.8114572543455206e-15)))))));
            return x + (x * rest + roundingOfRadians(angle, x) * (1 - 0.5 * squared));
        }

        // The cosine of -45 to 45 degrees. The series: 1/4!, 1/6!, ... 1/18!, after 1 - x x / 2.
        private static function cosineOfSmall(angle:Number):Number
        {
            var x:Number = angle * RADIANS;
            var squared:Number = x * x;
            var rest:Number = squared * squared * (0.041666666666666664 + squared * (-0.001388888888888889 + squared * (2.48015873015873e-5
                            + squared * (-2.755731922398589e-7 + squared * (2.08767569878681e-9 + squared * (-1.1470745597729725e-11
                                        + squared * (4.779477332387385e-14 - squared * 1.5619206968586225e-16)))))));
            var half:Number = 0.5 * squared;
            var most:Number = 1 - half;
            return most + (1 - most - half + (rest - x * roundingOfRadians(angle, x)));
        }

        // The rounding error of an angle that was multiplied by RADIANS.
        private static function roundingOfRadians(angle:Number, radians:Number):Number
        {
            return roundingOfProduct(angle, RADIANS, radians) + angle * RADIANS_REST;
        }
    }
}
