package starlogo.terrain
{
    import evaluation.pairs.SeededRandom;
    import flash.geom.Vector3D;
    import org.flexunit.asserts.assertTrue;
    import starlogo.GreatLand;
    import starlogo.agents.Agent;
    import starlogo.collision.Collider;
    import starlogo.collision.Contact;
    import starlogo.models.BuiltInModel;
    import starlogo.models.Model;
    import starlogo.queries.AgentQueries;
    import support.Complaints;
    import support.EachCollider;
    import support.Effort;
    import support.agentAt;

    /** Contacts with the ground, and with the corner of a model, lead out by about the shortest way: nobody is thrown over a wall. */
    public class GroundContactsTest
    {
        // What a way may be longer than the shortest that many directions find.
        private static const MOST:Number = 1.5;

        // Beside holes the search may miss the shortest way: of 2,000 ways, one is more than 1.5 times as long.
        private static const MOST_BESIDE_HOLES:Number = 2;
        private static const HAIR:Number = 1e-9;

        // How much farther the rounding of a place leads, as a fraction of the place.
        private static const ROUNDING:Number = 1e-14;
        private static const SHAPES:Array = ["sphere", "cylinder", "cube", "ell"];

        private var _land:GreatLand = new GreatLand();
        private var _random:SeededRandom = new SeededRandom(48);
        private var _wrong:Complaints = new Complaints();
        private var _directions:Vector.<Vector3D> = new Vector.<Vector3D>();

        [Before]
        public function makeLand():void
        {
            _land.prepareExact = true;
            for each (var model:Model in [BuiltInModel.sphere(), BuiltInModel.cylinder(), BuiltInModel.cube(), modelOf("ell", [[0, 0, 0, 1, 0.3, 0.3],
                                [0, 0, 0, 0.3, 1, 0.3], [0, 0, 0, 0.3, 0.3, 1]]), modelOf("corner", [[0, 0, 0, 10, 1, 5], [0, 0, 0, 1, 10, 5]])])
            {
                _land.addModel(model);
            }
            for (var i:int = 0; i < 150; i++)
            {
                // a spiral from pole to pole
                var z:Number = 1 - (2 * i + 1) / 150;
                var across:Number = Math.sqrt(1 - z * z);
                _directions.push(new Vector3D(across * Math.cos(2.399963 * i), across * Math.sin(2.399963 * i), z));
            }
            for (i = 0; i < 27; i++)
            {
                var way:Vector3D = new Vector3D(i % 3 - 1, int(i / 3) % 3 - 1, int(i / 9) - 1);
                if (way.normalize() > 0)
                {
                    _directions.push(way);
                }
            }
        }

        [Test]
        public function aWallThatIsOnlyTouchedThrowsNobody():void
        {
            for each (var name:String in EachCollider.NAMES)
            {
                for each (var shape:String in name == "hierarchies" || name == "triangles" ? ["cube"] : ["cube", "sphere"])
                {
                    var terrain:Terrain = columns(9, 9, function(column:int, row:int):Number
                        {
                            return column > 4 ? 5 : 0;
                        });
                    var collider:Collider = EachCollider.make(name, _land);
                    for each (var into:Number in [0, 1e-9, 0.001, 0.02])
                    {
                        for each (var down:Number in [0.001, 0.02, 0.3])
                        {
                            var contact:Contact = collider.contactOf(agentAt(shape, into, 0.1, -down), terrain.agent);
                            var least:Number = Math.sqrt(into * into + down * down);
                            assertTrue(name + " " + shape + " " + into + " " + down + ": " + contact.depth + " along " + contact.normal, contact.depth < MOST * least);
                        }
                    }
                }
            }
        }

        [Test]
        public function cornersOfTwoAndThreeFacesAreLeftBetweenThem():void
        {
            var terrain:Terrain = columns(9, 9, function(column:int, row:int):Number
                {
                    return column > 4 || row > 4 ? 5 : 0;
                });
            for each (var name:String in ["tightest fits", "triangles"])
            {
                var contact:Contact = EachCollider.make(name, _land).contactOf(agentAt("cube", 0.1, 0.2, -0.2), terrain.agent);
                var off:Number = Math.abs(contact.depth - 0.3) + Vector3D.distance(contact.normal, new Vector3D(-1 / 3, -2 / 3, 2 / 3));
                assertTrue(name + ": " + contact.depth + " along " + contact.normal, off < 1e-6);
            }
        }

        [Test]
        public function theCornerOfTwoWallsOfAModelIsLeftBetweenThem():void
        {
            var corner:Agent = new Agent("corner");
            corner.size = 10;
            for each (var name:String in ["hierarchies", "triangles"])
            {
                // the inner sides of the walls are at -4, because the model stands about its middle
                for each (var into:Number in [0.001, 0.02, 0.1])
                {
                    var cube:Agent = agentAt("cube", -3.5 - into, -3.5 - into, 1);
                    var contact:Contact = EachCollider.make(name, _land).contactOf(cube, corner);
                    assertTrue(name + ", " + into + ": " + contact.depth + " along " + contact.normal, contact.depth < MOST * into * Math.SQRT2);
                }
            }
        }

        // All sides of the ground that the box is behind are farther away than the peak is high in it.
        [Test]
        public function whatIsOnAPeakIsLeftUpwards():void
        {
            var heights:Array = [2, 3, 1, 0, 3, 3, 2, 3, 0, 2, 3, 0, 2, 2, 1, 3];
            var terrain:Terrain = columns(4, 4, function(column:int, row:int):Number
                {
                    return heights[4 * row + column];
                });
            terrain.isBlocky = false;
            for each (var name:String in EachCollider.NAMES)
            {
                var contact:Contact = EachCollider.make(name, _land).contactOf(agentAt("cube", -0.5, -1, 2.5), terrain.agent);
                assertTrue(name + ": " + contact.depth + " along " + contact.normal, contact.depth < 0.5 + HAIR);
            }
        }

        /** The slope at the top of a hole's side may rise towards the hole: the way out to its front is long. */
        [Test]
        public function aHolesSideThatIsOnlyTouchedThrowsNobody():void
        {
            var touches:int = 0;
            for (var i:int = Effort.choose(300, 4000, 60); i > 0; i--)
            {
                var from:Number = _random.pick([0, 100, 1000, 1e5]);
                var terrain:Terrain = new Terrain(4, 4, 1, from, from);
                for (var k:int = 0; k < 16; k++)
                {
                    terrain.setHeight(k % 4, k / 4, _random.between(-0.3, 0.6));
                }
                terrain.setHole(1, 1, true);
                var name:String = _random.pick(["tightest fits", "hierarchies", "triangles"]);
                var collider:Collider = EachCollider.make(name, _land);
                var queries:AgentQueries = new AgentQueries(collider);
                queries.terrain = terrain;
                var agent:Agent = agentAt(_random.pick(["cube", "sphere", "cylinder"]), from + 1.5, from + 1.5, _random.between(-0.5, 0.5));
                agent.size = _random.between(0.1, 0.5);
                agent.heading = _random.pick([0, 0, 30]);
                queries.update(new <Agent>[agent]);
                if (!queries.touchesAny(agent) && queries.moveUntilTouch(agent, _random.pick([-1, 1, 0.1]), _random.pick([0, 0.3]), _random.pick([0, -0.2])) < 1
                        && collider.areColliding(agent, terrain.agent))
                {
                    touches++;
                    var contact:Contact = collider.contactOf(agent, terrain.agent);
                    _wrong.addIf(contact.depth > 2 * HAIR + ROUNDING * from, name + ", " + agent.shape, [from, contact.depth, "along", contact.normal].join(" "));
                }
            }
            _wrong.assertNone();
            assertTrue(touches + " touches", touches > 20);
        }

        /** A collider computes all contacts in one object. */
        [Test]
        public function aContactWithTheGroundChangesNoOtherContact():void
        {
            var terrain:Terrain = new Terrain(9, 9, 1, -4, -4);
            for (var i:int = 0; i < 60; i++)
            {
                var name:String = i % 2 == 0 ? "hierarchies" : "triangles";
                var ell:Agent = agentAt("ell", 0, 0, 0);
                var other:Agent = agentAt("ell", _random.between(-0.5, 0.5), _random.between(-0.5, 0.5), _random.between(-0.5, 0.5));
                other.heading = _random.between(0, 360);
                other.pitch = _random.between(0, 360);
                var collider:Collider = EachCollider.make(name, _land);
                collider.contactOf(agentAt("cube", 0, 0, -0.4), terrain.agent);
                var contact:Contact = collider.contactOf(ell, other);
                var expected:Contact = EachCollider.make(name, _land).contactOf(ell, other);
                var isSame:Boolean = contact.depth == expected.depth && contact.normal.equals(expected.normal) && contact.point.equals(expected.point);
                _wrong.addIf(!isSame, name, [i, contact.depth, "along", contact.normal, "is not", expected.depth, "along", expected.normal].join(" "));
            }
            _wrong.assertNone();
        }

        [Test]
        public function waysAreAboutTheShortest():void
        {
            var touches:int = 0;
            var count:int = Effort.choose(60, 4000, 10);
            for (var i:int = 0; touches < count; i++)
            {
                var terrain:Terrain = sceneOf(i);
                var name:String = _random.pick(EachCollider.NAMES);
                var collider:Collider = EachCollider.make(name, _land);
                var agent:Agent = new Agent(_random.pick(SHAPES));
                agent.size = terrain.cellWidth * _random.pick([0.3, 0.7, 1, 1.7, 2.5]);
                agent.hierarchical = _random.chance();
                if (_random.chance())
                {
                    agent.heading = _random.between(0, 360);
                }
                if (placeInCorner(collider, agent, terrain))
                {
                    touches++;
                    check(name + ", scene " + i, collider, agent, terrain);
                }
            }
            _wrong.assertNone();
        }

        [Test]
        public function waysBesideHolesAreAboutTheShortest():void
        {
            var touches:int = 0;
            var count:int = Effort.choose(40, 2000, 10);
            for (var i:int = 0; touches < count; i++)
            {
                var terrain:Terrain = sceneOf(i);
                for (var at:int = 0; at < 81; at++)
                {
                    terrain.setHole(at % 9, at / 9, _random.chance(0.25));
                }
                var name:String = _random.pick(EachCollider.NAMES);
                var collider:Collider = EachCollider.make(name, _land);
                var agent:Agent = new Agent(_random.pick(SHAPES));
                agent.size = terrain.cellWidth * _random.pick([0.3, 0.7, 1, 1.7, 2.5]);
                if (placeInCorner(collider, agent, terrain))
                {
                    touches++;
                    check(name + ", scene with holes " + i, collider, agent, terrain, MOST_BESIDE_HOLES);
                }
            }
            _wrong.assertNone();
        }

        /**
         * Deep in jagged ground, many planes meet where the search tries to get out. Far from the origin, the gap across which two touch because of
         * rounding is wider than 1e-9 of the agent.
         */
        [Test]
        public function deepInJaggedGroundNearTheOriginAndFarAway():void
        {
            var touches:int = 0;
            var count:int = Effort.choose(300, 4000, 10);
            while (touches < count)
            {
                var name:String = _random.pick(["tightest fits", "hierarchies", "triangles"]);
                var collider:Collider = EachCollider.make(name, _land);
                var agent:Agent = new Agent(_random.pick(SHAPES));
                agent.size = _random.between(0.1, 0.9);
                agent.heading = _random.between(0, 360);
                agent.roll = _random.pick([0, 40]);
                var from:Number = _random.pick([0, 1 << 20]);
                var terrain:Terrain = jaggedAt(from);
                agent.moveTo(from + _random.between(-2, 2), from + _random.between(-2, 2), _random.between(-3, 0.2));
                if (collider.areColliding(agent, terrain.agent))
                {
                    touches++;
                    check(name + ", from " + from, collider, agent, terrain);
                }
            }
            _wrong.assertNone();
        }

        /** Far from the origin, a way's end is rounded: the cube touches there, and is free only a little farther. */
        [Test]
        public function aWayWhoseEndIsRoundedIsNotMadeLonger():void
        {
            var heights:Array = [
                    -0.3765466789575822, -0.059178768082359, -0.18374599448161177, 0.025764929841973316, 0.0687861799507834,
                    0.2233287221014848, -1.9213747528118854, 0.2572243936521508, -0.4238421648560109, 0.19795956715025342,
                    -0.06338050019051633, -0.11396604255496201, -0.5911391316965156, -1.0391070329074437, -0.42562281171691385,
                    -1.497642655407294, -0.08450604186060628, -1.341737764766687, -0.6665624671288846, -1.7899438532659069,
                    0.18805683770237014, -1.5111336465425516, -0.8926847081514224, -0.956715430357044, -1.8703961658238129
                ];
            var terrain:Terrain = new Terrain(5, 5, 1, (1 << 20) - 2, (1 << 20) - 2);
            for (var at:int = 0; at < 25; at++)
            {
                terrain.setHeight(at % 5, at / 5, heights[at]);
            }
            var cube:Agent = agentAt("cube", 1048574.9740708366, 1048574.1624817813, -1.430840389533949);
            cube.size = 0.7851325586887385;
            cube.heading = 135.82101350264946;
            cube.roll = 40;
            check("triangles", EachCollider.make("triangles", _land), cube, terrain);
            _wrong.assertNone();
        }

        /**
         * A rod along a slope may be wholly under the ground. Then its first contact lifts it, from the bottom of the box around it. The middle of the
         * bottom is far from the rod, and much deeper.
         */
        [Test]
        public function rodsUnderASteepSlopeAreLeftAcrossIt():void
        {
            var random:SeededRandom = new SeededRandom(16);
            _land.addModel(BuiltInModel.box(6, 0.05, 0.05, "rod"));
            for (var i:int = Effort.choose(10, 1000, 4); i > 0; i--)
            {
                var angle:Number = random.between(50, 62);
                var slope:Number = Math.tan(angle * Math.PI / 180);
                var terrain:Terrain = columns(21, 21, function(column:int, row:int):Number
                    {
                        return slope * (column - 10) + random.between(-0.25, 0.25);
                    });
                terrain.isBlocky = false;
                var rod:Agent = new Agent("rod");
                rod.size = 0.6;
                rod.pitch = -angle;
                var x:Number = random.between(-3, 3);
                rod.moveTo(x, random.between(-3, 3), slope * x - random.between(3, 5.5));
                check("hierarchies, rod " + i, EachCollider.make("hierarchies", _land), rod, terrain);
                check("triangles, rod " + i, EachCollider.make("triangles", _land), rod, terrain);
            }
            _wrong.assertNone();
        }

        /** The cube stands in the ground, and so near a wall that rounding makes them touch. The way leads out of both. */
        [Test]
        public function aWallAcrossTheGapOfRoundingIsLeftToo():void
        {
            var terrain:Terrain = columns(9, 9, function(column:int, row:int):Number
                {
                    return column > 4 ? 1 : row > 4 ? 0.6 : 0;
                }, 1000);
            var cube:Agent = agentAt("cube", 149.99999999995725, 2323.208256245901, 586);
            cube.size = 700;
            for each (var name:String in EachCollider.NAMES)
            {
                check(name, EachCollider.make(name, _land), cube, terrain);
            }
            _wrong.assertNone();
        }

        private function jaggedAt(from:Number):Terrain
        {
            var terrain:Terrain = new Terrain(5, 5, 1, from - 2, from - 2);
            terrain.isBlocky = _random.chance(0.3);
            for (var at:int = 0; at < 25; at++)
            {
                terrain.setHeight(at % 5, at / 5, _random.between(-2, 0.3));
            }
            return terrain;
        }

        private function check(where:String, collider:Collider, agent:Agent, terrain:Terrain, most:Number = MOST):void
        {
            var contact:Contact = collider.contactOf(agent, terrain.agent);
            var depth:Number = contact.depth;
            var hair:Number = HAIR * Math.max(2 * agent.size, terrain.cellWidth) + ROUNDING * Math.abs(terrain.x);
            if (touches(collider, agent, terrain, contact.normal, depth + hair) || depth > hair && !touches(collider, agent, terrain, contact.normal, depth - hair))
            {
                _wrong.add(collider + " does not separate", where + ", " + agent + ": " + depth + " along " + contact.normal);
            }
            // free places that are nearer than two thirds of the way
            for each (var way:Vector3D in _directions)
            {
                for (var part:Number = 1 / 8; part <= 1 && depth > 100 * hair; part += 1 / 8)
                {
                    if (!touches(collider, agent, terrain, way, part * depth / most))
                    {
                        _wrong.add("a way is too long", where + ", " + agent.shape + " of " + agent.size + ": " + depth + " along " + contact.normal + ", not "
                                + part * depth / most + " along " + way);
                        return;
                    }
                }
            }
        }

        private static function touches(collider:Collider, agent:Agent, terrain:Terrain, way:Vector3D, by:Number):Boolean
        {
            var x:Number = agent.x;
            var y:Number = agent.y;
            var z:Number = agent.z;
            agent.moveTo(x + by * way.x, y + by * way.y, z + by * way.z);
            var areTouching:Boolean = collider.areColliding(agent, terrain.agent);
            agent.moveTo(x, y, z);
            return areTouching;
        }

        // Lets an agent down onto the ground, and moves it to the walls beside it, as deep as is random. Returns whether it touches.
        private function placeInCorner(collider:Collider, agent:Agent, terrain:Terrain):Boolean
        {
            var width:Number = terrain.cellWidth;
            agent.moveTo(_random.between(-2, 2) * width, _random.between(-2, 2) * width, 30 * width);
            go(collider, agent, terrain, new Vector3D(0, 0, -1), 60 * width);
            go(collider, agent, terrain, new Vector3D(_random.pick([-1, 1]), 0, 0), width);
            go(collider, agent, terrain, new Vector3D(0, _random.pick([-1, 1]), 0), width);
            agent.z -= _random.pick([0, 0.001, 0.02, 0.1, 0.3]) * agent.size;
            return collider.areColliding(agent, terrain.agent);
        }

        private function go(collider:Collider, agent:Agent, terrain:Terrain, way:Vector3D, far:Number):void
        {
            var low:Number = 0;
            var high:Number = far;
            for (var i:int = 0; i < 40; i++)
            {
                var middle:Number = (low + high) / 2;
                if (touches(collider, agent, terrain, way, middle))
                {
                    high = middle;
                }
                else
                {
                    low = middle;
                }
            }
            low += way.z == 0 && high < far ? _random.pick([0, 0.001, 0.02, 0.1]) * agent.size : 0;
            agent.moveTo(agent.x + low * way.x, agent.y + low * way.y, agent.z + low * way.z);
        }

        private function sceneOf(i:int):Terrain
        {
            var high:Number = _random.pick([0.02, 0.3, 1, 5]);
            var middles:Array = [function(column:int, row:int):Number
                {
                    return column > 4 ? high : 0;
                }, function(column:int, row:int):Number
                {
                    return column > 4 || row > 4 ? high : 0;
                }, function(column:int, row:int):Number
                {
                    return column > 4 ? high : row > 4 ? 0.6 * high : 0;
                }, function(column:int, row:int):Number
                {
                    return _random.between(0, high);
                }, function(column:int, row:int):Number
                {
                    return -Math.abs(column - 4) * high;
                }
            ];
            var terrain:Terrain = columns(9, 9, middles[i % middles.length], _random.pick([0.1, 1, 1000]));
            terrain.isBlocky = i % 3 > 0;
            return terrain;
        }

        private static function columns(columns:int, rows:int, heightOf:Function, width:Number = 1):Terrain
        {
            var terrain:Terrain = new Terrain(columns, rows, width, -(columns >> 1) * width, -(rows >> 1) * width);
            terrain.isBlocky = true;
            for (var at:int = 0; at < columns * rows; at++)
            {
                terrain.setHeight(at % columns, int(at / columns), width * heightOf(at % columns, int(at / columns)));
            }
            return terrain;
        }

        private static function modelOf(name:String, boxes:Array):Model
        {
            var vertices:Vector.<Number> = new Vector.<Number>();
            var triangles:Vector.<uint> = new Vector.<uint>();
            for each (var box:Array in boxes)
            {
                var first:uint = vertices.length / 3;
                for (var i:int = 0; i < 8; i++)
                {
                    vertices.push(box[i & 1 ? 3 : 0], box[i & 2 ? 4 : 1], box[i & 4 ? 5 : 2]);
                }
                for each (var face:Array in [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]])
                {
                    triangles.push(first + face[0], first + face[1], first + face[2], first + face[0], first + face[2], first + face[3]);
                }
            }
            return new Model(name, vertices, triangles);
        }
    }
}
