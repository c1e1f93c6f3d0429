package starlogo.models
{
    import flash.geom.Vector3D;
    import starlogo.engine;
    import starlogo.geometry.Placement;

    use namespace engine;

    /**
     * How a model is turned, scaled and moved before it is used: what the StarLogo Nova client's transform files say (<code>bear.slb</code>
     * beside <code>bear.obj</code>). It stands in place of an up axis: what it turns is taken as it is in the file.
     *
     * <p>A transform never changes. It turns about x first, then y, then z, axes that stay; by right angles exactly. What of it a model shows
     * depends on how that is scaled: see <code>Model.FOOTPRINT</code>, <code>VOLUME</code> and <code>AS_GIVEN</code>.</p>
     */
    public final class ModelTransform
    {
        private var _rotation:Vector3D;
        private var _scale:Vector3D;
        private var _translation:Vector3D;

        /**
         * Copies what it is given.
         *
         * @param rotation degrees about x, y and z; null for none
         * @param scale factors along x, y and z, after the rotation; null for 1
         * @param translation how far along x, y and z, after all else; null for not at all
         * @throws RangeError if a number is not finite, or a factor 0
         */
        public function ModelTransform(rotation:Vector3D = null, scale:Vector3D = null, translation:Vector3D = null)
        {
            _rotation = rotation == null ? new Vector3D() : rotation.clone();
            _scale = scale == null ? new Vector3D(1, 1, 1) : scale.clone();
            _translation = translation == null ? new Vector3D() : translation.clone();
            if (!isFinitePoint(_rotation) || !isFinitePoint(_translation) || !isScale(_scale))
            {
                throw new RangeError("a transform needs finite numbers, and factors other than 0, not the rotation " + _rotation + ", the scale " +
                        _scale + " and the translation " + _translation);
            }
        }

        /**
         * Reads the text of a transform file. Its lines are words between single blanks: <code>rotate x y z</code>,
         * <code>scale x y z</code>, <code>scale s</code> and <code>translate x y z</code>; of each the last one counts. All else is passed
         * over, as the client does it: other words, what has fewer words, and <code>invert</code>, which turns nothing but the light. So are
         * lines without numbers where they should have some, and factors of 0, of which the client makes a model that can't be drawn.
         *
         * @param text the file's; null is as an empty one
         */
        public static function fromText(text:String):ModelTransform
        {
            var turn:Vector3D = null;
            var factors:Vector3D = null;
            var move:Vector3D = null;
            for each (var line:String in (text || "").split("\r").join("").split("\n"))
            {
                var words:Array = line.split(" ");
                var x:Number = numberIn(words[1]);
                var isEven:Boolean = words.length < 4;
                var numbers:Vector3D = isEven ? new Vector3D(x, x, x) : new Vector3D(x, numberIn(words[2]), numberIn(words[3]));
                if (words[0] == "scale" && isScale(numbers))
                {
                    factors = numbers;
                }
                else if (words[0] == "rotate" && !isEven && isFinitePoint(numbers))
                {
                    turn = numbers;
                }
                else if (words[0] == "translate" && !isEven && isFinitePoint(numbers))
                {
                    move = numbers;
                }
            }
            return new ModelTransform(turn, factors, move);
        }

        // As parseFloat() reads it: what follows the number does not matter.
        private static function numberIn(word:String):Number
        {
            var found:Array = word == null ? null : /^\s*([-+]?(\d+\.?\d*|\.\d+)([eE][-+]?\d+)?)/.exec(word);
            return found == null ? NaN : Decimal.of(found[1]);
        }

        /** Degrees about x, y and z. */
        public function get rotation():Vector3D
        {
            return _rotation.clone();
        }

        /** Factors along x, y and z. */
        public function get scale():Vector3D
        {
            return _scale.clone();
        }

        /** How far along x, y and z. */
        public function get translation():Vector3D
        {
            return _translation.clone();
        }

        /** Whether it does nothing. */
        public function get isIdentity():Boolean
        {
            return _rotation.lengthSquared == 0 && _translation.lengthSquared == 0 && _scale.x == 1 && _scale.y == 1 && _scale.z == 1;
        }

        /** The text of a transform file that says the same. */
        public function toString():String
        {
            return "rotate " + wordsOf(_rotation) + "\nscale " + wordsOf(_scale) + "\ntranslate " + wordsOf(_translation) + "\n";
        }

        /**
         * The rotation as a matrix.
         *
         * @private
         */
        internal function rotationMatrix():AffineTransform
        {
            var turned:Placement = new Placement();
            turned.setRotation(_rotation.z, _rotation.y, _rotation.x);
            return AffineTransform.of(turned);
        }

        private static function isFinitePoint(point:Vector3D):Boolean
        {
            return point.x - point.x + point.y - point.y + point.z - point.z == 0;
        }

        private static function isScale(factors:Vector3D):Boolean
        {
            return isFinitePoint(factors) && factors.x != 0 && factors.y != 0 && factors.z != 0;
        }

        private static function wordsOf(point:Vector3D):String
        {
            return point.x + " " + point.y + " " + point.z;
        }
    }
}
