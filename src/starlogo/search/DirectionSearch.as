package starlogo.search
{
    import flash.geom.Vector3D;
    import starlogo.convex.ContactPoint;
    import starlogo.convex.RelativeMotion;
    import starlogo.engine;
    import starlogo.geometry.Tolerances;

    use namespace engine;

    /**
     * Finds the distance at which two touching bodies are free of each other if the first one moves along a direction. It tries places farther and farther away until the two do not touch. Then
     * it sweeps back to the place where they part. The surfaces have a normal at that place. Along this normal the way out is usually shorter. For
     * convex bodies it always is, because it is at most the depth times the cosine of the angle between the two directions. So it tries that
     * normal next. It improves a direction twice at most.
     */
    internal class DirectionSearch
    {
        // A contact is shallow if its depth is less than this fraction of the larger extent. The search for a way out also begins with steps of
        // this length.
        protected static const SHALLOW:Number = 1 / 256;

        // How often a normal is improved at most. Another direction counts as better if its depth is less than GAIN times the old depth.
        protected static const IMPROVEMENTS:int = 2;
        protected static const GAIN:Number = 0.95;

        // The interval between a touching and a free distance is halved until it is shorter than this fraction of the larger extent. The rest
        // is swept.
        protected static const NARROW:Number = 1 / 16;

        // The most halvings. After 53 a Number has no more bits to halve.
        protected static const MOST_STEPS:int = 60;

        // The tests of the pair; the first body, at the place that is tried, and the second; the first body's place at the touch; the larger of
        // the two extents; and the gap across which they touch because places are rounded.
        protected var _tests:PairTests;
        protected var _a:Body = new Body();
        protected var _b:Body;
        protected var _from:Vector3D = new Vector3D();
        protected var _extent:Number = 0;
        protected var _rounding:Number = 0;
        protected var _place:Vector3D = new Vector3D();

        // The direction that is tried; a distance along it at which the two touch, a distance at which they do not, and the next step towards it.
        protected var _along:Vector3D = new Vector3D();
        protected var _touching:Number = 0;
        protected var _free:Number = 0;
        protected var _step:Number = 0;

        // How far the first body is moved along the direction. This is a field because V8 makes an object for each Number that is passed.
        protected var _distance:Number = 0;

        // The sweep back, and the contact at its end.
        protected var _back:RelativeMotion = new RelativeMotion();
        protected var _left:ContactPoint = new ContactPoint();

        // Sweeps back from the free distance. If the contact is not shallow, improves the direction. Then the point becomes the middle between the
        // place where the two part and the matching place on the first body.
        protected function refine(out:ContactPoint):void
        {
            sweepBack(out);
            if (out.depth > SHALLOW * _extent)
            {
                for (var left:int = IMPROVEMENTS; left > 0 && isShorterAlongLeft(out); left--)
                {
                    _touching = 0;
                    sweepBack(out);
                }
                out.x = _left.x - out.depth / 2 * out.normalX;
                out.y = _left.y - out.depth / 2 * out.normalY;
                out.z = _left.z - out.depth / 2 * out.normalZ;
            }
            makeSure(out);
        }

        // Tries the normal of the surfaces at the end of the way. Returns whether the way out along it is shorter.
        protected function isShorterAlongLeft(out:ContactPoint):Boolean
        {
            var cosine:Number = _left.normalX * out.normalX + _left.normalY * out.normalY + _left.normalZ * out.normalZ;
            if (!(cosine > 0 && cosine < GAIN))
            {
                return false;
            }
            point(_left);
            _free = cosine * out.depth + Tolerances.SEPARATION * _extent;
            return !touchesFree();
        }

        // Takes the direction of a contact's normal. Its depth is the first guess of the free distance.
        protected function goOutAlong(contact:ContactPoint):void
        {
            point(contact);
            _free = contact.depth + Tolerances.SEPARATION * _extent;
            _step = SHALLOW * _extent;
            goOut();
        }

        // Increases the free distance by longer and longer steps, until the two do not touch there.
        protected function goOut():void
        {
            _touching = 0;
            while (touchesFree() && _free < 1e300)
            {
                _touching = _free;
                _free += _step;
                _step *= 2;
            }
        }

        // Finds the place where the two part: it is between a place where they touch and a place where they do not. Its distance becomes the
        // contact's depth.
        protected function sweepBack(out:ContactPoint):void
        {
            while (_free - _touching > NARROW * _extent)
            {
                halve();
            }
            _distance = _touching;
            displace();
            var way:Number = _touching - _free;
            _back.endAfter(way * _along.x, way * _along.y, way * _along.z);
            _tests.findImpact(_a, _b, _back, _left);
            var time:Number = Math.min(_back.time, 1);
            out.setNormal(_along.x, _along.y, _along.z);
            out.depth = _free + time * way;
        }

        protected function halve():void
        {
            var middle:Number = (_touching + _free) / 2;
            _distance = middle;
            if (touch())
            {
                _touching = middle;
            }
            else
            {
                _free = middle;
            }
        }

        // Makes sure, in spite of rounding, that the two do not touch a little beyond a contact's depth, and touch a little before it.
        protected function makeSure(out:ContactPoint):void
        {
            var slack:Number = Tolerances.SEPARATION / 4 * _extent;
            point(out);
            _free = out.depth + slack;
            _step = slack;
            goOut();
            if (_touching == 0)
            {
                _distance = out.depth - slack;
                if (_distance <= 0 || touch())
                {
                    return;
                }
                _free = _distance;
            }
            for (var i:int = 0; i < MOST_STEPS && _free - _touching > slack; i++)
            {
                halve();
            }
            out.depth = (_free + _touching) / 2;
        }

        protected function point(contact:ContactPoint):void
        {
            _along.setTo(contact.normalX, contact.normalY, contact.normalZ);
        }

        protected function touchesFree():Boolean
        {
            _distance = _free;
            return touch();
        }

        // Whether the two touch if the first one is moved along the direction by the distance.
        protected function touch():Boolean
        {
            displace();
            return _tests.areTouching(_a, _b);
        }

        protected function displace():void
        {
            _place.setTo(_from.x + _distance * _along.x, _from.y + _distance * _along.y, _from.z + _distance * _along.z);
            _a.moveTo(_place);
        }
    }
}
