package starlogo.models.collada
{
    import starlogo.geometry.AffineTransform;
    import starlogo.models.shortened;

    /** A COLLADA document at rest or at a time of an animation: the numbers that its elements have then, and where its nodes are. */
    internal final class ColladaPose
    {
        /** The document. Its poses share its geometries and skins. */
        public var document:ColladaDocument;

        private var _animation:ColladaAnimation;
        private var _time:Number;
        private var _places:Object = {}; // lists of the places of a node, in the scene's order, by the node's index

        // of the elements that were asked for, by their indices: the scene may place an element often
        private var _numbers:Object = {};
        private var _transforms:Object = {};

        /**
         * @param document the document
         * @param animation moves it; null at rest
         * @param time of the document, in seconds
         */
        public function ColladaPose(document:ColladaDocument, animation:ColladaAnimation, time:Number)
        {
            this.document = document;
            _animation = animation;
            _time = time;
        }

        /** Whether nothing moves. */
        public function get isAtRest():Boolean
        {
            return _animation == null;
        }

        /** The numbers that the animation gives to an element; null if they stay. */
        public function numbersOf(element:ColladaElement):Vector.<Number>
        {
            if (_animation != null && !(element.index in _numbers))
            {
                _numbers[element.index] = _animation.numbersOf(element, _time);
            }
            return _numbers[element.index];
        }

        /** The transform that an element is; null if it is none. */
        public function transformOf(element:ColladaElement):AffineTransform
        {
            var numbers:Vector.<Number> = numbersOf(element);
            return numbers == null ? element.toTransform() : (_transforms[element.index] ||= ColladaTransform.of(element, numbers));
        }

        /** Takes a place of a node in the scene. */
        public function addPlace(place:ColladaPlace):void
        {
            (_places[place.node.index] ||= []).push(place);
        }

        /**
         * What takes points of a joint to the scene. If the joint has several places, that counts which is in the innermost place around the
         * skin that has one of them. So each of several figures has joints of its own. Of several places there, the first counts.
         *
         * @param joint the joint's node
         * @param skin where the skin is
         * @param user the skin's element, for the error
         * @throws ModelError if the joint is not in the scene
         */
        public function jointAt(joint:ColladaElement, skin:ColladaPlace, user:ColladaElement):AffineTransform
        {
            var places:Array = _places[joint.index];
            user.refuseIf(places == null, "its joint \"" + shortened(joint.attribute("sid") || joint.id) + "\" is not in the scene");
            for (var around:ColladaPlace = skin; places.length > 1 && around != null; around = around.around)
            {
                var next:int = indexFrom(places, around.first);
                if (next < places.length && places[next].first < around.end)
                {
                    return places[next].transform;
                }
            }
            return places[0].transform;
        }

        // The index of the first place that has at least so many places before it.
        private static function indexFrom(places:Array, first:int):int
        {
            var low:int = 0;
            var high:int = places.length;
            while (low < high)
            {
                var middle:int = (low + high) >> 1;
                if (places[middle].first < first)
                {
                    low = middle + 1;
                }
                else
                {
                    high = middle;
                }
            }
            return low;
        }
    }
}
