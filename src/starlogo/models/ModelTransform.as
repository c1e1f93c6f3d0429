package starlogo.models
{
    import flash.geom.Vector3D;
    import starlogo.engine;
    import starlogo.geometry.AffineTransform;
    import starlogo.geometry.Placement;
    import starlogo.models.files.ModelFile;
    import starlogo.models.text.Decimal;

    use namespace engine;

    /**
     * Turns, scales and moves a model before it is used. The transform files of the StarLogo Nova client contain one (<code>bear.slb</code>
     * beside <code>bear.obj</code>). Pass it instead of an up axis. It applies to the coordinates as they are in the file.
     *
     * <p>A transform never changes. It turns about the fixed axes x, y and z, in this order. Right angles are exact. The scaling of the
     * model decides which parts of the transform have an effect: see <code>Model.FOOTPRINT</code>, <code>VOLUME</code> and
     * <code>AS_GIVEN</code>.</p>
     */
    public final class ModelTransform
    {
        private var _rotation:Vector3D;
        private var _scale:Vector3D;
        private var _translation:Vector3D;

        /**
         * Copies the three vectors.
         *
         * @param rotation degrees about x, y and z; null for none
         * @param scale factors along x, y and z, applied after the rotation; null for 1
         * @param translation distances along x, y and z, applied last; null for none
         * @throws RangeError if a number is not finite, or a factor is 0
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
         * Reads the text of a transform file. The words of a line are separated by single spaces: <code>rotate x y z</code>, <code>scale
         * x y z</code>, <code>scale s</code> and <code>translate x y z</code>. Of two factors the first counts for all. If a kind of line appears
         * more than once, the last one counts. All other lines are ignored, as the client does: unknown words, too few words, and
         * <code>invert</code>, which changes only the light. If a word should be a number and is not, its line is ignored too. Factors of 0
         * are ignored too, because the client can't draw such a model.
         *
         * @param text the file's text; null counts as empty
         */
        public static function fromText(text:String):ModelTransform
        {
            var turn:Vector3D = null;
            var factors:Vector3D = null;
            var move:Vector3D = null;
            for each (var line:String in ModelFile.withoutByteOrderMark(text || "").split("\r").join("").split("\n"))
            {
                var words:Array = line.split(" ");
                var hasThree:Boolean = words.length >= 4;
                var numbers:Vector3D = new Vector3D(numberIn(words[1]), numberIn(words[hasThree ? 2 : 1]), numberIn(words[hasThree ? 3 : 1]));
                if (words[0] == "scale" && isScale(numbers))
                {
                    factors = numbers;
                }
                else if (words[0] == "rotate" && hasThree && isFinitePoint(numbers))
                {
                    turn = numbers;
                }
                else if (words[0] == "translate" && hasThree && isFinitePoint(numbers))
                {
                    move = numbers;
                }
            }
            return new ModelTransform(turn, factors, move);
        }

        // Reads a number as parseFloat() does: text after the number is ignored.
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

        /** Distances along x, y and z. */
        public function get translation():Vector3D
        {
            return _translation.clone();
        }

        /** Whether it changes nothing. */
        public function get isIdentity():Boolean
        {
            return _rotation.equals(new Vector3D()) && _translation.equals(new Vector3D()) && _scale.equals(new Vector3D(1, 1, 1));
        }

        /**
         * Whether it makes a mirror image.
         *
         * @private
         */
        engine function get isMirror():Boolean
        {
            // of three factors, one or all are negative
            return (_scale.x < 0) != (_scale.y < 0) != (_scale.z < 0);
        }

        /** The text of a transform file with the same meaning. */
        public function toString():String
        {
            return "rotate " + wordsOf(_rotation) + "\nscale " + wordsOf(_scale) + "\ntranslate " + wordsOf(_translation) + "\n";
        }

        /** @private The rotation alone. */
        engine function rotationTransform():AffineTransform
        {
            var placement:Placement = new Placement();
            placement.setRotation(_rotation.z, _rotation.y, _rotation.x);
            return AffineTransform.of(placement);
        }

        private static function isFinitePoint(point:Vector3D):Boolean
        {
            return isFinite(point.x) && isFinite(point.y) && isFinite(point.z);
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
