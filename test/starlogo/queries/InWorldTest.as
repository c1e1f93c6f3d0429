package starlogo.queries
{
    import flash.geom.Vector3D;
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertTrue;
    import org.flexunit.asserts.fail;
    import starlogo.GreatLand;
    import starlogo.agents.Agent;
    import starlogo.bounding.Box;
    import starlogo.bounding.Capsule;
    import starlogo.bounding.Sphere;
    import starlogo.collision.Contact;
    import starlogo.collision.TightestFitCollider;
    import starlogo.models.BuiltInModel;
    import starlogo.terrain.Terrain;
    import starlogo.terrain.TerrainSurface;
    import starlogo.terrain.WorldBounds;
    import support.assertThrows;
    import support.assign;
    import support.create;
    import support.landOf;

    /** What a game passes to questions and to the ground is in the world, or it is refused with its value, and nothing has changed. */
    public class InWorldTest
    {
        private static const OUTSIDE:Array = [NaN, Infinity, -Infinity, 1.001e9, 1e10, -1e10, 1e155, -1e200, 1e308, undefined];

        private var _queries:AgentQueries;
        private var _terrain:Terrain;
        private var _bear:Agent;

        [Before]
        public function makeWorld():void
        {
            var greatLand:GreatLand = landOf(BuiltInModel.cube());
            _queries = new AgentQueries(new TightestFitCollider(greatLand));
            _terrain = new Terrain(4, 4);
            _queries.terrain = _terrain;
            _bear = new Agent("cube");
            _bear.moveTo(1, 1, 2);
            var other:Agent = new Agent("cube");
            other.moveTo(2.5, 1, 2);
            _queries.update(new <Agent>[_bear, other]);
        }

        // Everything that takes a place, a point, a motion or a structure: by name, a function of three numbers.
        private function get calls():Object
        {
            var up:Vector3D = new Vector3D(0, 0, 1);
            var capsule:Capsule = new Capsule(new Vector3D(), up, 1);
            return {
                    nearPoint: calling(_queries.nearPoint, [], pointOf, [1]),
                    countNearPoint: calling(_queries.countNearPoint, [], pointOf, [1]),
                    nearestToPoint: calling(_queries.nearestToPoint, [], pointOf),
                    distanceToPoint: calling(_queries.distanceToPoint, [_bear], pointOf),
                    distanceOfTheGround: calling(_queries.distanceToPoint, [_terrain.agent], pointOf),
                    overlapsAgent: calling(_queries.overlapsAgent, [_bear]),
                    cast: calling(_queries.cast, [], pointOf, [up]),
                    castAll: calling(_queries.castAll, [], pointOf, [up]),
                    overlapping: calling(_queries.overlapping, [], sphereAt),
                    overlappingAnother: calling(_queries.overlapping, [], wideBox),
                    castShape: calling(_queries.castShape, [new Sphere(new Vector3D(), 1)]),
                    castOfAShapeThere: calling(_queries.castShape, [], sphereAt, [1, 0, 0]),
                    castShapeAll: calling(_queries.castShapeAll, [capsule]),
                    castAgent: calling(_queries.castAgent, [_bear]),
                    castAgentAll: calling(_queries.castAgentAll, [_bear]),
                    moveUntilTouch: calling(_queries.moveUntilTouch, [_bear]),
                    slide: calling(_queries.slide, [_bear]),
                    raiseMound: function(x:*, y:*, z:*):void
                    {
                        _terrain.raiseMound(x, y, 2, z);
                    },
                    raiseWall: calling(_terrain.raiseWall, []),
                    setHeights: calling(_terrain.setHeights, [0, 0, 3, 1], heightsOf)
                };
        }

        // Calls a function with some arguments, what is made of three numbers, or these themselves, and more arguments.
        private static function calling(call:Function, before:Array, make:Function = null, after:Array = null):Function
        {
            return function(x:*, y:*, z:*):void
            {
                call.apply(null, before.concat(make == null ? [x, y, z] : [make(x, y, z)], after || []));
            };
        }

        private static function heightsOf(x:*, y:*, z:*):Vector.<Number>
        {
            return new <Number>[x, y, z];
        }

        [Test]
        public function whatIsOutsideIsRefusedWithItsValue():void
        {
            var before:String = look();
            for (var name:String in calls)
            {
                for each (var wrong:* in OUTSIDE)
                {
                    for (var axis:int = 0; axis < 3; axis++)
                    {
                        var numbers:Array = [1, 1, 1];
                        numbers[axis] = wrong;
                        assertRefuses(name + " " + numbers, calls[name], numbers, wrong);
                    }
                }
                assertEquals(name, before, look());
                calls[name](1, 1, 0.5);
                makeWorld();
            }
        }

        [Test]
        public function whatAnAgentIsAskedAboutNamesIt():void
        {
            var all:Object = calls;
            var named:RegExp = /^agent \d+ \(breed "turtles", shape "cube"\): dy of a motion must be a finite number between -1000000000 and 1000000000, not .*NaN$/;
            for each (var name:String in ["castAgent", "castAgentAll", "moveUntilTouch", "slide"])
            {
                assertThrows(RangeError, named, all[name], 0, NaN, 0);
            }
            assertThrows(RangeError, named, _queries.walk, _bear, 0, NaN);
            assertThrows(RangeError, /^agent \d+ .*: dx of a motion must be a finite number between .*, not 2000000000$/, _queries.walk, _bear, 2e9, NaN);
            assertThrows(RangeError, /^agent \d+ .*: a place must be a finite number between .*NaN$/, _queries.wouldTouchAt, _bear, 0, 0, NaN);
            assertThrows(RangeError, /^dy of a motion must be a finite number between/, all.castShape, 0, NaN, 0);
            assertThrows(RangeError, /: dz of a motion must be a finite number between .*, not -Infinity$/, all.slide, 0, 0, -Infinity);
        }

        [Test]
        public function placesOnTheGroundAndItsOwnNumbersToo():void
        {
            for each (var wrong:* in OUTSIDE)
            {
                assertRefuses("heightAt", _terrain.heightAt, [wrong, 0], wrong);
                assertRefuses("heightAt", _terrain.heightAt, [0, wrong], wrong);
                assertRefuses("normalAt", _terrain.normalAt, [wrong, 0], wrong);
                assertRefuses("normalAt", _terrain.normalAt, [0, wrong], wrong);
                assertRefuses("setHeight", _terrain.setHeight, [1, 1, wrong], wrong);
                assertRefuses("a mound's width", _terrain.raiseMound, [1, 1, wrong, 1], wrong);
                assertRefuses("a walk", _queries.walk, [_bear, wrong, 0], wrong);
                assertRefuses("a walk", _queries.walk, [_bear, 0, wrong], wrong);
            }
            assertTrue(isNaN(_terrain.heightAt(1e9, 0)));
            for (var i:int = 0; i < 4; i++)
            {
                var borders:Array = [0, 0, 2, 2];
                borders[i] = NaN;
                assertThrows(RangeError, /NaN/, create, TerrainSurface, _terrain, borders[0], borders[1], borders[2], borders[3]);
            }
        }

        [Test]
        public function lengthsMayBeInfiniteWhereThatMeansSomething():void
        {
            for each (var radius:Number in [1e10, 1e155, 1e308, Infinity])
            {
                assertEquals(1, _queries.near(_bear, radius).length);
                assertEquals(1, _queries.countNear(_bear, radius));
                assertEquals(2, _queries.countNearPoint(new Vector3D(1e9, -1e9, 1e9), radius));
                assertEquals(1, _queries.inCone(_bear, radius, radius).length);
                assertTrue(_queries.cast(new Vector3D(1, 1, 9), new Vector3D(0, 0, -1), radius).agent === _bear);
            }
            for each (var wrong:* in [NaN, -1, -Infinity, undefined])
            {
                assertRefuses("near", _queries.near, [_bear, wrong], wrong);
                assertRefuses("countNear", _queries.countNear, [_bear, wrong], wrong);
                assertRefuses("countNearPoint", _queries.countNearPoint, [new Vector3D(), wrong], wrong);
                assertRefuses("inCone", _queries.inCone, [_bear, wrong, 9], wrong);
                assertRefuses("inCone", _queries.inCone, [_bear, 9, wrong], wrong);
            }
            var options:WalkOptions = new WalkOptions();
            for each (var name:String in ["stepHeight", "snap", "fall"])
            {
                for each (var length:Number in [NaN, -1, -Infinity, 1.1e9, 1e308])
                {
                    assertThrows(RangeError, new RegExp(name + " .*must be between 0 and 1000000000, not " + textOf(length).replace("+", "\\+")), assign, options, name, length);
                }
            }
            assertThrows(RangeError, /snap must be between 0 and 1000000000, not Infinity/, assign, options, "snap", Infinity);
            assertThrows(RangeError, /slopeDegrees .*less than 90: 90/, assign, options, "slopeDegrees", 90);
            options.fall = Infinity;
            assertEquals(Infinity, options.fall);
        }

        [Test]
        public function theEndOfTheWorldIsInIt():void
        {
            var far:Vector3D = new Vector3D(1e9, -1e9, 1e9);
            assertEquals(0, _queries.nearPoint(far, 1e3).length);
            assertTrue(_queries.distanceToPoint(_terrain.agent, far) > 1e9);
            assertTrue(_queries.distanceToPoint(_bear, far) > 1e9);
            assertTrue(_queries.cast(new Vector3D(0, 0, 1e9), new Vector3D(0, 0, -1)).agent === _terrain.agent);
            assertEquals(null, _queries.castShape(new Sphere(far, 1e9 - 10), 1e9, -1e9, 1e9));
            assertEquals(3, _queries.overlapping(wideBox(9e8, 9e8, 9e8)).length);
            assertEquals("as far as agents may be", 1e9, Agent.LARGEST_COORDINATE);
        }

        [Test]
        public function whatWouldLeaveTheWorldWritesNoAnswer():void
        {
            var place:Number = Agent.LARGEST_COORDINATE - 1;
            _bear.moveTo(place, 1, 2);
            _queries.moved(_bear);
            var footing:Footing = new Footing();
            var contact:Contact = new Contact();
            footing.part = footing.pushed = contact.time = -7;
            footing.stands = true;
            assertThrows(RangeError, /between/, _queries.walk, _bear, 5, 0, null, footing);
            assertEquals("-7,-7,true", [footing.part, footing.pushed, footing.stands].join());
            assertThrows(RangeError, /between/, _queries.moveUntilTouch, _bear, 5, 0, 0, null, contact);
            assertEquals(-7, contact.time);
            assertEquals(place, _bear.x);
        }

        [Test]
        public function nothingIsNoPoint():void
        {
            for each (var ask:Function in [_queries.nearPoint, _queries.countNearPoint])
            {
                assertThrows(ArgumentError, /null/, ask, null, 1);
            }
            assertThrows(ArgumentError, /null/, _queries.nearestToPoint, null);
            assertThrows(ArgumentError, /null/, _queries.distanceToPoint, _bear, null);
            assertThrows(ArgumentError, /null/, _queries.cast, null, new Vector3D(1, 0, 0));
            assertThrows(ArgumentError, /null/, _queries.overlapping, null);
        }

        // The ground and the edges have no place: what is asked from a place is refused. What touches them can be asked.
        [Test]
        public function theGroundAndTheEdgesHaveNoPlace():void
        {
            for each (var fixture:Agent in [_terrain.agent, new WorldBounds(-9, -9, -9, 9, 9, 9).agent])
            {
                var asked:Array = [[_queries.near, fixture, 9], [_queries.countNear, fixture, 9], [_queries.nearest, fixture], [_queries.nearestOf, fixture, 2],
                        [_queries.inCone, fixture, 9, 90], [_queries.overlapsAgent, fixture, 1, 1, 1], [_queries.canSee, fixture, _bear],
                        [_queries.canSee, _bear, fixture], [_queries.castAgent, fixture, 1, 0, 0], [_queries.castAgentAll, fixture, 1, 0, 0],
                        [_queries.moveUntilTouch, fixture, 1, 0, 0], [_queries.slide, fixture, 1, 0, 0], [_queries.walk, fixture, 1, 0]];
                for each (var call:Array in asked)
                {
                    assertThrows.apply(null, [ArgumentError, /has no place, and does not move/].concat(call));
                }
                assertEquals(0, _queries.touching(fixture).length);
                _bear.z = -0.5;
                _queries.moved(_bear);
                assertEquals(fixture === _terrain.agent ? 1 : 0, _queries.touching(fixture).length);
                _bear.z = 2;
                _queries.moved(_bear);
            }
        }

        private function look():String
        {
            var heights:Array = [_bear.x, _bear.y, _bear.z, _queries.near(_bear, Infinity).length];
            for (var i:int = 0; i < 16; i++)
            {
                heights.push(_terrain.getHeight(i % 4, i / 4));
            }
            return heights.join();
        }

        private static function assertRefuses(what:String, call:Function, args:Array, wrong:*):void
        {
            try
            {
                call.apply(null, args);
            }
            catch (error:Error)
            {
                // the module refuses what is no number before the engine sees it
                assertTrue(what + ": " + error, wrong === undefined || error is RangeError);
                var named:Array = error.message.match(/(-?[0-9.e+]+|-?Infinity|NaN|undefined)$/);
                // the extents of a turned box are wider by rounding errors
                var isNamed:Boolean = wrong === undefined || named != null && (textOf(wrong) == named[1] || Math.abs(Number(named[1]) / wrong - 1) < 1e-12);
                assertTrue(what + ": " + error.message, isNamed);
                return;
            }
            fail(what + " is not refused: " + args);
        }

        // In Flash a missing number is NaN.
        private static function textOf(wrong:*):String
        {
            return String(Number(wrong));
        }

        private static function pointOf(x:*, y:*, z:*):Vector3D
        {
            var point:Vector3D = new Vector3D();
            point.x = x;
            point.y = y;
            point.z = z;
            return point;
        }

        private static function sphereAt(x:*, y:*, z:*):Sphere
        {
            var sphere:Sphere = new Sphere(new Vector3D(), 1);
            sphere.center = pointOf(x, y, z);
            return sphere;
        }

        // A box about the origin with these half lengths.
        private static function wideBox(x:Number, y:Number, z:Number):Box
        {
            var box:Box = new Box(new Vector3D(), Vector3D.X_AXIS, Vector3D.Y_AXIS, Vector3D.Z_AXIS, 1, 1, 1);
            box.halfX = x;
            box.halfY = y;
            box.halfZ = z;
            return box;
        }
    }
}
