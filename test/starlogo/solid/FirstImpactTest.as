package starlogo.solid
{
    import evaluation.pairs.SeededRandom;
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertTrue;
    import starlogo.GreatLand;
    import starlogo.agents.Agent;
    import starlogo.collision.Collision;
    import starlogo.collision.CombinationCollider;
    import starlogo.collision.Contact;
    import starlogo.convex.RelativeMotion;
    import starlogo.convex.TrianglePlane;
    import starlogo.geometry.Tolerances;
    import starlogo.models.BuiltInModel;
    import starlogo.models.Model;
    import starlogo.terrain.Terrain;
    import support.Complaints;
    import support.Effort;

    /** What sweeps flush beside something else, or on the same plane, touches the side that stops it, and not a side that it grazes. */
    public class FirstImpactTest
    {
        // The lengths of the models along y and z. The models stand on z = 0.
        private static const WIDTHS:Object = {wall: 3, cube: 1, block: 2};
        private static const HEIGHTS:Object = {wall: 3, cube: 1, block: 3};

        private var _random:SeededRandom = new SeededRandom(88);
        private var _wrong:Complaints = new Complaints();
        private var _land:GreatLand = new GreatLand();
        private var _collider:CombinationCollider;
        private var _collision:Collision;
        private var _contact:Contact;

        [Before]
        public function setUp():void
        {
            _land.loadHulls = true;
            _land.addModel(BuiltInModel.box(1, 3, 3, "wall"));
            _land.addModel(BuiltInModel.box(1, 1, 1, "cube"));
            _land.addModel(BuiltInModel.box(1, 2, 3, "block"));
            _collider = new CombinationCollider(_land);
            _collider.exact = true;
            _collision = new Collision(_collider);
            _collision.onCollision("movers", Collision.ANY_BREED, keep);
            _collision.onCollision("movers", Collision.TERRAIN, keep);
        }

        [Test]
        public function boxesThatStandFlush():void
        {
            for (var i:int = 0; i < Effort.choose(300, 6000, 60); i++)
            {
                var mover:Agent = new Agent(_random.pick(["wall", "cube", "block"]), "movers");
                var other:Agent = new Agent(_random.pick(["wall", "cube", "block"]), "walls");
                other.hierarchical = _random.chance(0.8);
                mover.hierarchical = !other.hierarchical || _random.chance(0.5);
                mover.collideAs = mover.hierarchical ? "tightest" : _random.pick(["box", "hull"]);
                other.collideAs = other.hierarchical ? "tightest" : _random.pick(["box", "hull"]);
                other.heading = _random.pick([0, 90, _random.between(0, 360)]);
                var beside:Number = (WIDTHS[mover.shape] - WIDTHS[other.shape]) / 2;
                var above:Number = HEIGHTS[other.shape] - HEIGHTS[mover.shape];
                sweep(mover, other, _random.pick([0, beside, -beside, _random.between(-1, 1)]), _random.pick([0, above, _random.between(-0.9, 0.9)]), i);
            }
            _wrong.assertNone();
        }

        [Test]
        public function columnsThatAnAgentIsFlushWith():void
        {
            // two walls of columns, from y = -10.5 to 1.5; the cell borders are at halves
            var terrain:Terrain = new Terrain(21, 21, 1, -10, -10);
            terrain.isBlocky = true;
            for (var column:int = 0; column < 21; column++)
            {
                for (var row:int = 0; row < 21; row++)
                {
                    terrain.setHeight(column, row, (column < 7 || column > 13) && row < 12 ? 2 : -3);
                }
            }
            _collision.terrain = terrain;
            for (var i:int = 0; i < Effort.choose(100, 2000, 30); i++)
            {
                var mover:Agent = new Agent(_random.pick(["cube", "block"]), "movers");
                var side:int = _random.pick([-1, 1]);
                mover.hierarchical = _random.chance(0.4);
                mover.collideAs = mover.hierarchical ? "tightest" : _random.pick(["box", "hull"]);
                mover.sweeps = true;
                mover.moveTo(0, 1.5 - WIDTHS[mover.shape] / 2 * _random.pick([1, _random.between(-0.9, 3)]), _random.pick([2, _random.between(-1, 1)]));
                _collision.update(new <Agent>[mover]);
                mover.x = 5 * side;
                _contact = null;
                _collision.update(new <Agent>[mover]);
                note(-side, 0, mover.toString() + " " + mover.collideAs + " " + i);
            }
            _wrong.assertNone();
        }

        /** What is beside a contact does not turn it, however large the triangles are: here a roof above the cube, near beside the plate's size. */
        [Test]
        public function theBorderOfAHugePlateUnderARoof():void
        {
            var plate:Vector.<Number> = new <Number>[0, -1, 0, 1, -1, 0, 1, 1, 0, 0, 1, 0, -1, -1, 5e-5, 1, -1, 5e-5, 1, 1, 5e-5, -1, 1, 5e-5];
            _land.addModel(new Model("plate", plate, new <uint>[0, 1, 2, 0, 2, 3, 4, 5, 6, 4, 6, 7], Model.AS_GIVEN));
            for (var i:int = 0; i < 50; i++)
            {
                var mover:Agent = new Agent("cube", "movers");
                var other:Agent = new Agent("plate", "walls");
                var y:Number = _random.between(-400, 400);
                mover.hierarchical = other.hierarchical = mover.sweeps = true;
                other.size = 1000;
                mover.moveTo(-6, y, -1);
                _collision.update(new <Agent>[mover, other]);
                mover.moveTo(-0.2, y, -1);
                _contact = null;
                _collision.update(new <Agent>[mover, other]);
                note(-1, 0, "at " + y);
            }
            _wrong.assertNone();
        }

        /** Touches at about the same time come in the order of the tree. The same one counts in every order. */
        [Test]
        public function theOrderOfTheTouchesDoesNotMatter():void
        {
            var first:FirstImpact = new FirstImpact();
            var motion:RelativeMotion = new RelativeMotion();
            motion.x = 3;
            for (var i:int = 0; i < 2000; i++)
            {
                var touches:Array = [];
                for (var k:int = 0; k < 4; k++)
                {
                    touches.push({time: 0.5 + _random.integer(0, 9) * 3e-10, squareness: _random.between(0.01, 1)});
                }
                var chosen:Object = null;
                for (var order:int = 0; order < 6; order++)
                {
                    touches.push(touches.splice(_random.integer(0, 3), 1)[0]);
                    var last:Object = null;
                    first.reset();
                    motion.latestTime = 1;
                    for each (var touch:Object in touches)
                    {
                        var plane:TrianglePlane = new TrianglePlane();
                        plane.normal.setTo(-touch.squareness, Math.sqrt(1 - touch.squareness * touch.squareness), 0);
                        motion.time = touch.time;
                        last = first.offer(motion, plane) ? touch : last;
                    }
                    chosen ||= last;
                    assertEquals("the squareness of touch set " + i, chosen.squareness, last.squareness);
                    _wrong.addIf(!(chosen.time <= first.time + Tolerances.SAME_TIME), "later", "set " + i);
                }
            }
            _wrong.assertNone();
        }

        // Sweeps a mover to another agent, along that one's x axis, beside its middle and above its bottom by two lengths.
        private function sweep(mover:Agent, other:Agent, y:Number, z:Number, i:int):void
        {
            var side:int = _random.pick([-1, 1]);
            var along:Number = Math.cos(other.heading * Math.PI / 180);
            var across:Number = Math.sin(other.heading * Math.PI / 180);
            var agents:Vector.<Agent> = i % 2 == 0 ? new <Agent>[mover, other] : new <Agent>[other, mover];
            mover.heading = other.heading;
            mover.sweeps = true;
            mover.moveTo(6 * side * along - y * across, 6 * side * across + y * along, z);
            _collision.update(agents);
            mover.moveTo(-y * across, y * along, z);
            _contact = null;
            _collision.update(agents);
            note(side * along, side * across, [mover, mover.collideAs, other, other.collideAs, other.heading, y, z, i].join(" "));
        }

        // Notes a contact whose normal is not along this direction.
        private function note(x:Number, y:Number, what:String):void
        {
            assertTrue(what, _contact != null);
            _wrong.addIf(!(_contact.normal.x * x + _contact.normal.y * y > 1 - 1e-9), "normal", what + ": " + _contact.normal);
        }

        private function keep(mover:Agent, other:Agent, contact:Contact):void
        {
            _contact = contact;
        }
    }
}
