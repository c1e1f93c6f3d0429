package soak
{
    import starlogo.agents.Agent;
    import starlogo.collision.Collision;

    /** Handlers for the starts and the ends of two breeds' touches: whether starts and ends take turns. */
    internal final class SoakTouches
    {
        private var _collision:Collision;
        private var _counts:SoakCounts;
        private var _witness:SoakWitness;
        private var _breed:String;
        private var _otherBreed:String;
        private var _isOn:Boolean = false;
        private var _open:Object = {};

        /**
         * @param collision gets the handlers
         * @param counts is told
         * @param witness likewise
         */
        public function SoakTouches(collision:Collision, counts:SoakCounts, witness:SoakWitness, breed:String, otherBreed:String)
        {
            _collision = collision;
            _counts = counts;
            _witness = witness;
            _breed = breed;
            _otherBreed = otherBreed;
        }

        /** Adds the two handlers, or takes them away: later touches begin anew. */
        internal function toggle():void
        {
            _isOn = !_isOn;
            if (_isOn)
            {
                _open = {};
                _collision.onCollisionStart(_breed, _otherBreed, onStart);
                _collision.onCollisionEnd(_breed, _otherBreed, onEnd);
            }
            else
            {
                _collision.removeHandler(_breed, _otherBreed, onStart);
                _collision.removeHandler(_breed, _otherBreed, onEnd);
            }
        }

        private function onStart(collider:Agent, collidee:Agent):void
        {
            var key:String = collider.id + " " + collidee.id;
            _counts.add("starts of touches");
            _witness.seePair(collider, collidee);
            if (_open.hasOwnProperty(key))
            {
                throw new Error("not meant: " + collider + " and " + collidee + " begin to touch again");
            }
            _open[key] = true;
        }

        private function onEnd(collider:Agent, collidee:Agent):void
        {
            var key:String = collider.id + " " + collidee.id;
            _counts.add("ends of touches");
            _witness.seePair(collider, collidee);
            if (!_open.hasOwnProperty(key))
            {
                throw new Error("not meant: " + collider + " and " + collidee + " cease to touch, but never began");
            }
            delete _open[key];
        }
    }
}
