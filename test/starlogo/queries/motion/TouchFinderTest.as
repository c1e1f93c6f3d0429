package starlogo.queries.motion
{
    import evaluation.pairs.RandomStructures;
    import evaluation.pairs.SeededRandom;
    import flash.geom.Vector3D;
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertFalse;
    import org.flexunit.asserts.assertTrue;
    import starlogo.agents.Agent;
    import starlogo.bounding.BoundingStructure;
    import starlogo.bounding.Box;
    import starlogo.bounding.Capsule;
    import starlogo.bounding.Hull;
    import starlogo.bounding.Sphere;
    import starlogo.engine;
    import starlogo.models.BuiltInModel;
    import starlogo.models.Model;
    import starlogo.queries.SeenAgents;
    import starlogo.search.Body;
    import support.Complaints;
    import support.EachCollider;
    import support.Effort;
    import support.EveryTriangle;
    import support.PlainDistance;
    import support.agentAt;
    import support.landOf;

    use namespace engine;

    /** Which triangle a motion's contact has: the one that the sweep met, or none if the motion begins deep. */
    public class TouchFinderTest
    {
        // Triangles whose distances from the contact differ by less have the contact both.
        private static const TIE:Number = 1e-7;

        private var _random:SeededRandom = new SeededRandom(7310);
        private var _structures:RandomStructures = new RandomStructures(_random);
        private var _model:Model = BuiltInModel.sphere();
        private var _seen:SeenAgents = new SeenAgents(EachCollider.make("triangles", landOf(_model)));
        private var _body:MovingBody = new MovingBody(_seen);
        private var _finder:TouchFinder = new TouchFinder();
        private var _result:MotionResult;
        private var _corners:Vector.<Number> = new Vector.<Number>();
        private var _wrong:Complaints = new Complaints();
        private var _met:int = 0;
        private var _deep:int = 0;

        [Test]
        public function spheres():void
        {
            compare(function(at:Vector3D, axes:Vector.<Vector3D>):BoundingStructure
                {
                    return new Sphere(at, 0.2);
                });
        }

        [Test]
        public function capsules():void
        {
            compare(function(at:Vector3D, axes:Vector.<Vector3D>):BoundingStructure
                {
                    var half:Vector3D = axes[0].clone();
                    half.scaleBy(0.3);
                    return new Capsule(at.subtract(half), at.add(half), 0.1);
                });
        }

        [Test]
        public function boxes():void
        {
            compare(function(at:Vector3D, axes:Vector.<Vector3D>):BoundingStructure
                {
                    return new Box(at, axes[0], axes[1], axes[2], 0.1, 0.2, 0.3);
                });
        }

        [Test]
        public function hulls():void
        {
            compare(function(at:Vector3D, axes:Vector.<Vector3D>):BoundingStructure
                {
                    var points:Vector.<Number> = new Vector.<Number>();
                    for (var i:int = 0; i < 8; i++)
                    {
                        points.push(at.x + _random.between(-0.2, 0.2), at.y + _random.between(-0.2, 0.2), at.z + _random.between(-0.2, 0.2));
                    }
                    return new Hull(points);
                });
        }

        // Its sweep meets no surface, or the surface from inside.
        [Test]
        public function nothingStopsWhatBeginsInsideOfAClosedModel():void
        {
            var from:Vector3D = new Vector3D(0.1, 0.2, 2);
            assertStops(false, from, new Vector3D(0, 0.1, 0));
            assertStops(false, from, new Vector3D(9, 0, 0));
        }

        // Its sweep begins with a contact, also if it leaves the surface.
        [Test]
        public function whatBeginsAcrossASurfaceIsStoppedOnTheWayInwards():void
        {
            var from:Vector3D = new Vector3D(2, 0, 2);
            assertStops(true, from, new Vector3D(-0.5, 0, 0));
            assertTrue("deep", _result.startsPenetrating);
            assertStops(false, from, new Vector3D(9, 0, 0));
            assertFalse("nothing stops it, so nothing is deep", _result.startsPenetrating);
        }

        private function assertStops(isStopped:Boolean, from:Vector3D, motion:Vector3D):void
        {
            sweepSphere(from, motion);
            assertEquals(motion.toString(), isStopped, _result.row >= 0);
        }

        // Sweeps a small sphere among the triangles of a large one.
        private function sweepSphere(from:Vector3D, motion:Vector3D):void
        {
            var agent:Agent = agentAt(_model.name, 0, 0, 0);
            agent.size = 4;
            agent.hierarchical = true;
            _seen.update(new <Agent>[agent]);
            _body.setToStructure(new Sphere(from, 0.1));
            _body.aim(motion.x, motion.y, motion.z);
            new NearRows(_seen).findAlong(_body, null);
            _result = _finder.findTouches(_body);
        }

        private function compare(make:Function):void
        {
            var motion:Vector3D = new Vector3D();
            for (var i:int = Effort.choose(150, 3000); i > 0; i--)
            {
                var agent:Agent = agentAt(_model.name, _random.between(-9, 9), _random.between(-9, 9), _random.between(-9, 9));
                agent.size = _random.between(1, 3);
                agent.hierarchical = true;
                _seen.update(new <Agent>[agent]);
                EveryTriangle.place(agent.placement, _model, _corners);
                // from outside, or from across the surface
                var isFar:Boolean = i % 3 > 0;
                var side:Vector3D = _structures.direction();
                side.scaleBy((isFar ? 1.5 : 0.5) * agent.size);
                var middle:Vector3D = new Vector3D(agent.x, agent.y, agent.z + agent.size / 2);
                _body.setToStructure(make(middle.add(side), _structures.frame()));
                motion.setTo(_random.between(-0.3, 0.3) - 1.2 * side.x, _random.between(-0.3, 0.3) - 1.2 * side.y, _random.between(-0.3, 0.3) - 1.2 * side.z);
                _body.aim(motion.x, motion.y, motion.z);
                new NearRows(_seen).findAlong(_body, null);
                _result = _finder.findTouches(_body);
                if (_result.row >= 0)
                {
                    check(_seen.table.bodyOf(_result.row));
                }
            }
            _wrong.assertNone();
            assertTrue(_met + " met, " + _deep + " begin deep", _met > 60 && _deep > 30);
        }

        private function check(tree:Body):void
        {
            if (_result.startsPenetrating)
            {
                assertEquals("the contact's plane stands for all triangles", -1, _result.contact.triangle);
                _deep++;
                return;
            }
            _met++;
            var nearest:int = _seen.narrowPhase.treeTests.findNearestTriangle(tree, _result.contact);
            var triangle:int = _result.contact.triangle;
            if (triangle != nearest)
            {
                _wrong.addIf(triangle < 0 || distanceTo(triangle) > distanceTo(nearest) + TIE, "another triangle",
                        triangle + " at " + distanceTo(triangle) + ", not " + nearest + " at " + distanceTo(nearest));
            }
        }

        private function distanceTo(triangle:int):Number
        {
            var x:Number = _result.contact.x;
            var y:Number = _result.contact.y;
            var z:Number = _result.contact.z;
            return triangle < 0 ? Infinity : PlainDistance.ofTriangles(new <Number>[x, y, z, x, y, z, x, y, z], 0, _corners, 9 * triangle);
        }
    }
}
